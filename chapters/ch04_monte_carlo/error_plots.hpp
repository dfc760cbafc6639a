/// @file
/// Plots of how errors fall: measured points, fitted laws.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "ch04_monte_carlo/darts.hpp"
#include "ch04_monte_carlo/error_study.hpp"
#include "ch04_monte_carlo/estimator.hpp"
#include "common/plot.hpp"

namespace lt {

/// One way to estimate, under the name that plots and tables give it.
struct NamedEstimator {
  std::string name;
  Estimator estimate;
  double exact;
};

[[nodiscard]] inline NamedEstimator plain(const KnownIntegral& integral) {
  return {integral.name + ", plain",
          [=](int n, Pcg32& random) {
            return estimate_uniform(integral.f, integral.a, integral.b, n, random).mean();
          },
          integral.exact};
}

[[nodiscard]] inline NamedEstimator stratified(const KnownIntegral& integral) {
  return {integral.name + ", stratified",
          [=](int n, Pcg32& random) {
            return estimate_stratified(integral.f, integral.a, integral.b, n, random);
          },
          integral.exact};
}

/// Pi by stratified darts; the side of the grid is the root of n, rounded down.
[[nodiscard]] inline NamedEstimator stratified_pi() {
  return {"pi, stratified",
          [](int n, Pcg32& random) {
            const auto side = static_cast<int>(std::sqrt(n));
            return estimate_pi(throw_stratified_darts(side, random)).mean();
          },
          std::numbers::pi};
}

/// A slope with its error, as people write it: "slope -0.501 +- 0.004".
[[nodiscard]] inline std::string slope_text(const PowerLaw& law) {
  char text[64];
  std::snprintf(text, sizeof text, "slope\u00a0%s%.3f \u00b1\u00a0%.3f",
                law.slope < 0 ? "\u2212" : "", std::abs(law.slope), law.standard_error);
  return text;
}

// [add-errors]
/// Adds the measured errors as points and the fitted law as a line.
inline void add_errors(Plot& plot, const std::string& name, const std::vector<ErrorAtN>& errors) {
  const PowerLaw law = law_of(errors);
  Series measured;
  for (const ErrorAtN& error : errors)
    measured.add(error.n, error.rms());
  add_dots_and_line(plot, measured, name + ": " + slope_text(law),
                    [&](double n) { return law.at(n); });
}
// [add-errors]

/// An empty plot of errors against the number of samples.
[[nodiscard]] inline Plot error_axes(const std::string& title, const std::string& description) {
  Plot plot;
  plot.title = title;
  plot.x_label = "n, samples";
  plot.y_label = "error (root mean square of 200 runs)";
  plot.log_x = plot.log_y = true;
  plot.description = description;
  return plot;
}

/// The smooth integral: 200 runs for each n from 16 to 16,384.
[[nodiscard]] inline Plot error_plot(std::uint64_t seed) {
  Plot plot = error_axes("Integral of the sine: error against samples",
                         "Both axes are logarithmic. The plain estimate's errors lie on a line of "
                         "slope minus one half: four times the samples for half the error. Those "
                         "of the stratified one fall on a line of slope minus three halves: at "
                         "16,384 samples they are thousands of times smaller.");
  for (const NamedEstimator& way : {plain(sine()), stratified(sine())})
    add_errors(plot, way.name, measure_error(way.estimate, way.exact, 16, 16384, 200, seed));
  return plot;
}

/// The integrand with a jump, and pi.
[[nodiscard]] inline Plot edge_plot(std::uint64_t seed) {
  Plot plot = error_axes("An edge, on a line and in the plane",
                         "Both axes are logarithmic. Without strata the error of the edge falls "
                         "with slope minus one half. With strata it falls with slope minus one on "
                         "the line, and with slope minus three quarters for the disk in the "
                         "plane.");
  for (const NamedEstimator& way : {plain(edge()), stratified(edge())})
    add_errors(plot, way.name, measure_error(way.estimate, way.exact, 16, 16384, 200, seed));
  const NamedEstimator way = stratified_pi();  // n must be a square: every second one
  add_errors(plot, way.name, measure_error(way.estimate, way.exact, 16, 16384, 200, seed, 4));
  return plot;
}

}  // namespace lt
