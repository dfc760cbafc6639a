/// @file
/// The power law behind measured points.
#pragma once

#include <cassert>
#include <cmath>
#include <span>

namespace lt {

// [power-law]
/// y = factor x^slope
struct PowerLaw {
  double slope;
  double standard_error;  ///< of the slope, from how far the points lie off the line
  double factor;

  [[nodiscard]] double at(double x) const { return factor * std::pow(x, slope); }
};
// [power-law]

// [fit-power-law]
/// The straight line through points on logarithmic axes that leaves the least sum of squares: on
/// such axes a power law is a line, and its exponent is the line's slope.
/// @param x, y  > 0, as many of each, at least 3, not all x equal
[[nodiscard]] inline PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size() && x.size() >= 3);
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / n;
    mean_y += std::log(y[i]) / n;
  }
  double xx = 0, xy = 0, yy = 0;  // sums of products of the deviations
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = std::log(x[i]) - mean_x;
    const double dy = std::log(y[i]) - mean_y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  const double slope = xy / xx;
  const double off_line = std::fmax(0, yy - slope * xy);  // sum of squares that is left
  return {slope, std::sqrt(off_line / (n - 2) / xx), std::exp(mean_y - slope * mean_x)};
}
// [fit-power-law]

}  // namespace lt
