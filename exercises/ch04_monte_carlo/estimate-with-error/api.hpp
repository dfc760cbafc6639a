/// @file
/// Exercise 04.3: what you write and what the checker calls.
#pragma once

#include <cstdint>
#include <functional>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Mean and error of numbers that come one at a time and are not kept.
class RunningMean {
 public:
  /// One number more.
  void add(double value);

  [[nodiscard]] std::int64_t count() const { return count_; }

  /// Mean of all numbers so far; 0 before the first.
  [[nodiscard]] double mean() const;

  /// Estimates the variance of the distribution that the numbers come from, without bias. 0 for
  /// fewer than two numbers.
  [[nodiscard]] double variance() const;

  /// How far mean() may be off: an estimate of its standard deviation. 0 for fewer than two
  /// numbers.
  [[nodiscard]] double standard_error() const;

 private:
  std::int64_t count_ = 0;
  double mean_ = 0.0;
  double spread_ = 0.0;  // yours to choose; no other memory is needed
};

/// Estimates the integral of f from a to b out of n random points, all equally likely.
/// @param n       points, >= 1
/// @param random  each call gives a new number, uniform in [0, 1)
/// @return mean() estimates the integral, standard_error() how far off that may be
[[nodiscard]] RunningMean estimate_uniform(const std::function<double(double)>& f, double a,
                                           double b, int n, const std::function<double()>& random);

}  // namespace exercise
