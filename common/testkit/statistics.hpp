/// @file
/// When is a random result wrong? Every learner is a new draw, so a test rejects only far out:
/// |z| > 6 or p < 1e-6, and an effect that matters.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace lt {

// [running-mean]
/// Mean and standard error of independent samples in one pass (Welford 1962).
class RunningMean {
 public:
  void add(double value);
  [[nodiscard]] std::int64_t count() const { return count_; }
  [[nodiscard]] double mean() const { return mean_; }
  /// Unbiased sample variance; 0 for fewer than two samples.
  [[nodiscard]] double variance() const;
  /// Standard error of the mean, sqrt(variance / count).
  [[nodiscard]] double standard_error() const;

 private:
  std::int64_t count_ = 0;
  double mean_ = 0;
  double sum_of_squares_ = 0;
};
// [running-mean]

// [z-test]
/// How far a sample mean lies from its expected value.
struct ZTest {
  double z;       ///< (mean - expected) / standard error; 0 if both agree exactly, +-inf if se is 0
  double effect;  ///< (mean - expected) / |expected|, or mean - expected where expected is 0
  /// True unless |z| > 6 *and* |effect| > smallest_effect: a right answer fails once in 5e8 draws.
  /// False if anything is NaN.
  [[nodiscard]] bool agrees(double smallest_effect = 0) const;
};
// [z-test]

[[nodiscard]] ZTest z_test(double mean, double standard_error, double expected);
[[nodiscard]] ZTest z_test(const RunningMean& sample, double expected);

/// Pearson's chi-square of observed counts against expected counts.
struct ChiSquare {
  double statistic;
  int degrees_of_freedom;
  double p_value;  ///< probability that right samples look this bad or worse
};

/// @param observed  counts, one per bin
/// @param expected  expected counts, as many; neighbouring bins are pooled until each expects at
///                  least `pool_below`. A sample in a bin that expects 0 gives p = 0, so does NaN.
[[nodiscard]] ChiSquare chi_square(std::span<const double> observed,
                                   std::span<const double> expected, double pool_below = 50);

/// Kolmogorov and Smirnov's largest distance between the samples' and a given distribution.
struct KolmogorovSmirnov {
  double distance;
  double p_value;  ///< asymptotic (Kolmogorov 1933, with Stephens' 1970 correction for finite n)
};

/// @param cdf  the distribution function, rising from 0 to 1
[[nodiscard]] KolmogorovSmirnov kolmogorov_smirnov(std::vector<double> samples,
                                                   const std::function<double(double)>& cdf);

/// Upper tail of the chi-square distribution, Q(dof/2, x/2).
[[nodiscard]] double chi_square_tail(double x, int degrees_of_freedom);

/// Adaptive Gauss-Kronrod quadrature of f over [a, b] in double precision. It starts with 120
/// values of f: a peak much narrower than 1/100 of the interval may lie between them.
/// @param tolerance  absolute error aimed at; where f is too noisy for it (it may compute in
///                   float), the error is that of f
/// @return NaN if f gives NaN or infinity
[[nodiscard]] double integrate(const std::function<double(double)>& f, double a, double b,
                               double tolerance = 1e-10);

/// The same over [ax, bx] x [ay, by].
[[nodiscard]] double integrate_2d(const std::function<double(double, double)>& f, double ax,
                                  double bx, double ay, double by, double tolerance = 1e-8);

}  // namespace lt
