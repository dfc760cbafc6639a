/// @file
/// Plots of two formulas that fail.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "ch04_monte_carlo/densities.hpp"
#include "ch04_monte_carlo/integrals.hpp"
#include "ch04_monte_carlo/mistakes.hpp"
#include "common/plot.hpp"

namespace lt {

/// The mean of the first n values, for n along a logarithmic axis.
/// @param value  called with the generator, returns the next value
template <class Value>
[[nodiscard]] Series running_mean(const std::string& label, int n, Pcg32 random,
                                  const Value& value) {
  Series series{label, {}, {}};
  RunningMean mean;
  std::int64_t next = 10;
  while (mean.count() < n) {
    mean.add(value(random));
    if (mean.count() < next) continue;
    next += 1 + next / 20;
    series.add(static_cast<double>(mean.count()), mean.mean());
  }
  return series;
}

/// The parabola's integral by the thesis' formula 12 as printed and as it should be.
[[nodiscard]] inline Plot thesis_plot(std::uint64_t seed) {
  const KnownIntegral integral = parabola();
  const PowerDensity ramp{1, integral.b};
  const Pcg32 random(seed);
  const auto uniform = [&](Pcg32& r) {
    return estimate_uniform(integral.f, integral.a, integral.b, 1, r).mean();
  };
  const auto right = [&](Pcg32& r) { return estimate_importance(integral.f, ramp, 1, r).mean(); };
  const auto printed = [&](Pcg32& r) {
    return mistakes::estimate_importance(integral.f, ramp, integral.a, integral.b, 1, r).mean();
  };
  Plot plot;
  plot.title = "Integral of x\u00b2 from 0 to 2, which is 8/3";
  plot.x_label = "n, samples";
  plot.y_label = "estimate";
  plot.log_x = true;
  plot.description =
      "Uniform samples and samples with density x/2 settle at 2.67, the latter sooner. With the "
      "printed formula's factor of the interval's length they settle at 5.33, twice too much.";
  plot.series = {running_mean("uniform", 20000, random, uniform),
                 running_mean("p = x/2", 20000, random, right),
                 running_mean("p = x/2, as printed", 20000, random, printed)};
  return plot;
}

/// Variance of the same thousand numbers moved away from 0, and its relative error.
[[nodiscard]] inline Plot offset_plot(std::uint64_t seed) {
  Series welford{"Welford", {}, {}, true, true};
  Series naive{"mean of squares minus square of mean", {}, {}, true, true};
  for (int power = 0; power <= 12; ++power) {
    const double offset = std::pow(10.0, power);
    const mistakes::Variances found = mistakes::variances_at_offset(offset, seed);
    welford.add(offset, std::abs(found.welford / found.exact - 1));
    naive.add(offset, std::abs(found.naive / found.exact - 1));
  }
  Plot plot;
  plot.title = "Variance of a thousand values, far from 0";
  plot.x_label = "added to every value";
  plot.y_label = "relative error of the variance";
  plot.log_x = plot.log_y = true;
  plot.description =
      "Both axes are logarithmic. The naive formula's error grows with the square of the offset "
      "and passes 1, all digits wrong, between ten and a hundred million. Welford's stays small.";
  plot.series = {welford, naive};
  return plot;
}

}  // namespace lt
