/// @file
/// Plots of what error bars and p-values are.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "ch04_monte_carlo/confidence.hpp"
#include "ch04_monte_carlo/darts.hpp"
#include "ch04_monte_carlo/densities.hpp"
#include "ch04_monte_carlo/integrals.hpp"
#include "ch04_monte_carlo/mistakes.hpp"
#include "ch04_monte_carlo/streams.hpp"
#include "common/plot.hpp"

namespace lt {

/// Lifts the pen: what follows is not joined to what was before.
inline constexpr double pen_up = std::numeric_limits<double>::quiet_NaN();

// [intervals]
/// Confidence intervals of the same integral, each from its own samples.
[[nodiscard]] inline std::vector<Interval> repeated_intervals(const KnownIntegral& integral,
                                                              int repeats, int n,
                                                              std::uint64_t seed) {
  std::vector<Interval> intervals;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    Pcg32 random = stream_for(seed, repeat, 0, 0);
    intervals.push_back(
        confidence_interval(estimate_uniform(integral.f, integral.a, integral.b, n, random)));
  }
  return intervals;
}
// [intervals]

/// A hundred of them as bars; those that miss the true value stand out.
[[nodiscard]] inline Plot interval_plot(std::uint64_t seed) {
  const KnownIntegral integral = sine();
  const std::vector<Interval> intervals = repeated_intervals(integral, 100, 256, seed);
  Series holding{"", {}, {}};
  Series missing{"", {}, {}};
  int misses = 0;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const bool is_miss = !intervals[i].holds(integral.exact);
    misses += is_miss;
    Series& series = is_miss ? missing : holding;
    const auto x = static_cast<double>(i + 1);
    series.x.insert(series.x.end(), {x, x, pen_up});
    series.y.insert(series.y.end(), {intervals[i].low, intervals[i].high, pen_up});
  }
  holding.label = std::to_string(100 - misses) + " hold the true value";
  missing.label = std::to_string(misses) + " miss it";
  Plot plot;
  plot.title = "A hundred 95 % intervals for the same integral";
  plot.x_label = "run";
  plot.y_label = "estimate \u00b1 1.96 standard errors, 256 samples";
  plot.description =
      "A hundred vertical bars around a level line at the true value, 2. Most cross "
      "the line; about five, in another color, lie above or below it.";
  plot.series = {holding, missing, {"true value", {1, 100}, {2, 2}}};
  return plot;
}

/// Pi against the number of darts, with its error bar.
[[nodiscard]] inline Plot pi_plot(int darts, Pcg32& random) {
  Series estimate{"estimate", {}, {}};
  Series low{"95 % interval", {}, {}};
  Series high{"", {}, {}};
  high.color_of = 1;
  RunningMean samples;
  std::int64_t next = 16;
  for (const vec2 dart : throw_darts(darts, random)) {
    samples.add(hits_disk(dart) ? 4 : 0);
    if (samples.count() < next) continue;
    next += 1 + next / 20;
    const Interval interval = confidence_interval(samples);
    for (Series* series : {&estimate, &low, &high})
      series->x.push_back(static_cast<double>(samples.count()));
    estimate.y.push_back(samples.mean());
    low.y.push_back(interval.low);
    high.y.push_back(interval.high);
  }
  const Series truth{"true value", {16.0, 1.0 * darts}, {std::numbers::pi, std::numbers::pi}};
  Plot plot;
  plot.title = "Pi by darts";
  plot.x_label = "darts";
  plot.y_label = "pi";
  plot.log_x = true;
  plot.description =
      "The estimate jumps about at first and settles near 3.14. The interval around it narrows "
      "like a funnel: to a tenth for a hundred times the darts.";
  plot.series = {estimate, low, high, truth};
  return plot;
}

// [p-values]
/// p-values of Kolmogorov and Smirnov's test of a sampler for p(x) = 3 x^2, one for each run,
/// sorted.
/// @param sample  called with a number in [0, 1), returns a sample
template <class Sample>
[[nodiscard]] std::vector<double> p_values(const Sample& sample, int runs, int n,
                                           std::uint64_t seed) {
  std::vector<double> values;
  for (int run = 0; run < runs; ++run) {
    Pcg32 random = stream_for(seed, run, n, 0);
    std::vector<double> samples;
    for (int i = 0; i < n; ++i)
      samples.push_back(sample(random.next_float()));
    values.push_back(
        kolmogorov_smirnov(samples, [](double x) { return PowerDensity{2}.cdf(x); }).p_value);
  }
  std::sort(values.begin(), values.end());
  return values;
}
// [p-values]

/// The share of runs with a p-value of at most x, as steps.
[[nodiscard]] inline Series share_of_runs(const std::string& label,
                                          const std::vector<double>& sorted) {
  Series steps{label, {0}, {0}};
  const auto runs = static_cast<double>(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (const std::size_t below : {i, i + 1}) {
      steps.add(sorted[i], static_cast<double>(below) / runs);
    }
  steps.add(1, 1);
  return steps;
}

/// p-values of a right sampler are uniform; those of a wrong one pile up at 0.
[[nodiscard]] inline Plot p_value_plot(std::uint64_t seed) {
  const auto right = [](double u) { return PowerDensity{2}.sample(u); };
  Plot plot;
  plot.title = "p-values of 200 runs";
  plot.x_label = "p-value";
  plot.y_label = "share of runs with at most this p-value";
  plot.description =
      "The p-values of the right sampler rise along the diagonal: every value is as likely as any "
      "other. Those of the wrong one, the square root for the cube root, bend away from it with "
      "50 samples, and with 500 all of them lie at 0.";
  plot.series = {
      share_of_runs("right, 500 samples", p_values(right, 200, 500, seed)),
      share_of_runs("wrong, 50 samples", p_values(mistakes::sample_parabola, 200, 50, seed)),
      share_of_runs("wrong, 500 samples", p_values(mistakes::sample_parabola, 200, 500, seed))};
  return plot;
}

}  // namespace lt
