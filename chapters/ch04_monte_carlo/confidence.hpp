/// @file
/// Error bars.
#pragma once

#include "common/testkit/statistics.hpp"

namespace lt {

// [interval]
/// A stretch of the number line that is meant to hold the true value.
struct Interval {
  double low, high;

  [[nodiscard]] bool holds(double value) const { return low <= value && value <= high; }
};

/// Half-width of a 95 % confidence interval in standard errors: a normal number lies farther out
/// once in 20 draws.
inline constexpr double standard_errors_95 = 1.959964;

/// mean +- standard_errors * standard error. Of many such intervals, about 95 of 100 hold the true
/// mean; which ones, nobody can say.
/// @param samples  some dozens at least, whose squares have a mean
[[nodiscard]] inline Interval confidence_interval(const RunningMean& samples,
                                                  double standard_errors = standard_errors_95) {
  const double reach = standard_errors * samples.standard_error();
  return {samples.mean() - reach, samples.mean() + reach};
}
// [interval]

}  // namespace lt
