/// @file
/// Plots of samples against the densities that they should have.
#pragma once

#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "ch04_monte_carlo/densities.hpp"
#include "ch04_monte_carlo/rejection.hpp"
#include "ch04_monte_carlo/tabulated.hpp"
#include "common/plot.hpp"

namespace lt {

// [histogram]
/// The share of samples in each of `bins` equal bins of [a, b), divided by the bin's width: what a
/// density means, turned round. Drawn as steps.
/// @param samples  those outside [a, b) count as samples but in no bin
[[nodiscard]] inline Series histogram(const std::vector<double>& samples, double a, double b,
                                      int bins) {
  std::vector<double> counts(static_cast<std::size_t>(bins));
  for (const double x : samples)
    if (x >= a && x < b) ++counts[static_cast<std::size_t>((x - a) / (b - a) * bins)];
  const double width = (b - a) / bins;
  Series steps{"samples", {}, {}};
  for (int i = 0; i < bins; ++i)
    for (const int end : {i, i + 1}) {
      steps.add(a + width * end, counts[static_cast<std::size_t>(i)] /
                                     (width * static_cast<double>(samples.size())));
    }
  return steps;
}
// [histogram]

/// A function as a curve.
template <class Function>
[[nodiscard]] Series curve(const std::string& label, const Function& f, double a, double b) {
  Series series{label, {}, {}};
  constexpr int steps = 240;
  for (int i = 0; i <= steps; ++i) {
    const double x = a + (b - a) * i / steps;
    series.add(x, f(x));
  }
  return series;
}

/// What all plots of densities have.
[[nodiscard]] inline Plot density_axes(const std::string& title, const std::string& description) {
  Plot plot;
  plot.title = title;
  plot.x_label = "x";
  plot.y_label = "density";
  plot.description = description;
  return plot;
}

template <Density P>
[[nodiscard]] std::vector<double> draw_samples(const P& density, int count, Pcg32& random) {
  std::vector<double> samples;
  for (int i = 0; i < count; ++i)
    samples.push_back(density.sample(random.next_float()));
  return samples;
}

[[nodiscard]] inline Plot inversion_plot(int count, Pcg32& random) {
  Plot plot = density_axes("Inversion: p(x) = 3x\u00b2",
                           "A histogram of samples climbs along the parabola 3 x squared from 0 "
                           "at x = 0 to 3 at x = 1; no bar is farther off than chance allows.");
  const PowerDensity parabola{2};
  plot.series = {histogram(draw_samples(parabola, count, random), 0, 1, 30),
                 curve(
                     "3x\u00b2", [&](double x) { return parabola.pdf(x); }, 0, 1)};
  return plot;
}

[[nodiscard]] inline Plot exponential_plot(int count, Pcg32& random) {
  Plot plot = density_axes("Inversion: p(x) = e\u207b\u02e3",
                           "A histogram of samples falls along the exponential curve from 1 at x "
                           "= 0 to nearly 0 at x = 6.");
  const ExponentialDensity fog;
  plot.series = {histogram(draw_samples(fog, count, random), 0, 6, 30),
                 curve(
                     "e\u207b\u02e3", [&](double x) { return fog.pdf(x); }, 0, 6)};
  return plot;
}

[[nodiscard]] inline Plot rejection_plot(int count, Pcg32& random) {
  Plot plot = density_axes("Rejection: p(x) = (2/\u03c0) \u221a(1 \u2212 x\u00b2)",
                           "A histogram of samples fills a half ellipse from x = -1 to x = 1.");
  std::vector<double> samples;
  for (int i = 0; i < count; ++i)
    samples.push_back(sample_by_rejection(semicircle, -1, 1, 1, random).x);
  plot.series = {histogram(samples, -1, 1, 30),
                 curve(
                     "(2/\u03c0) \u221a(1 \u2212 x\u00b2)",
                     [](double x) { return 2 / std::numbers::pi * semicircle(x); }, -1, 1)};
  return plot;
}

/// A table with gaps, at the start, in the middle and at the end.
[[nodiscard]] inline Plot tabulated_plot(int count, Pcg32& random) {
  Plot plot = density_axes("A table with empty bins",
                           "The density is a flight of steps over ten bins, of which the first, "
                           "the fifth, the sixth and the last are empty. The histogram of samples "
                           "follows the steps, and nothing falls into an empty bin.");
  const TabulatedDensity table(std::vector<double>{0, 1, 3, 2, 0, 0, 4, 2, 1, 0});
  plot.series = {histogram(draw_samples(table, count, random), 0, 1, 40),
                 curve(
                     "the table", [&](double x) { return table.pdf(x); }, 0, 1)};
  return plot;
}

}  // namespace lt
