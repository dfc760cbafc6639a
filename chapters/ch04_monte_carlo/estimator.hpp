/// @file
/// Integrals as means of random samples.
#pragma once

#include <concepts>

#include "ch04_monte_carlo/pcg32.hpp"
#include "common/testkit/statistics.hpp"

namespace lt {

// [estimate-uniform]
/// Estimates the integral of f over [a, b] from n points, all equally likely (thesis, section 4.2).
/// b < a gives the integral's sign, as it should.
/// @param n  samples, >= 1
/// @return mean() estimates the integral, standard_error() how far off it may be
template <class Function>
[[nodiscard]] RunningMean estimate_uniform(const Function& f, double a, double b, int n,
                                           Pcg32& random) {
  RunningMean samples;
  for (int i = 0; i < n; ++i) {
    const double u = random.next_float();
    samples.add((b - a) * f(a + (b - a) * u));
  }
  return samples;
}
// [estimate-uniform]

// [density]
/// A distribution of numbers.
///   sample(u)  a number made from u in [0, 1)
///   pdf(x)     the density with which sample() gives x; 0 where it never does
///   cdf(x)     the probability that sample() gives at most x, from 0 to 1
template <class T>
concept Density = requires(const T& density, double x, double u) {
  { density.sample(u) } -> std::same_as<double>;
  { density.pdf(x) } -> std::same_as<double>;
  { density.cdf(x) } -> std::same_as<double>;
};
// [density]

// [estimate-importance]
/// Estimates the integral of f from n samples of a density: the mean of f / p. Thesis eq. 12,
/// without its factor |b - a|.
/// @param density  positive wherever f is not 0
template <class Function, Density P>
[[nodiscard]] RunningMean estimate_importance(const Function& f, const P& density, int n,
                                              Pcg32& random) {
  RunningMean samples;
  for (int i = 0; i < n; ++i) {
    const double u = random.next_float();
    const double x = density.sample(u);
    samples.add(f(x) / density.pdf(x));
  }
  return samples;
}
// [estimate-importance]

// [estimate-stratified]
/// Estimates the integral of f over [a, b] from one random point in each of n equal parts. The
/// points are not equally distributed, so their spread does not tell the error: repeat to know it.
/// @param n  parts, >= 1
template <class Function>
[[nodiscard]] double estimate_stratified(const Function& f, double a, double b, int n,
                                         Pcg32& random) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double within = random.next_float();
    sum += f(a + (b - a) * (i + within) / n);
  }
  return (b - a) * sum / n;
}
// [estimate-stratified]

}  // namespace lt
