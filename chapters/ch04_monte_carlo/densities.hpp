/// @file
/// Densities whose cumulative distribution can be inverted with pen and paper.
#pragma once

#include <cmath>

#include "ch04_monte_carlo/estimator.hpp"

namespace lt {

// [power-density]
/// p(x) = (k + 1) x^k / end^(k + 1) over [0, end]: flat for power k = 0, a ramp for 1, a parabola
/// for 2 (3 x^2 if end is 1).
struct PowerDensity {
  double power;    ///< k, > -1
  double end = 1;  ///< positive

  /// cdf(x) = u, solved for x; with 1 - u for u, which is as uniform and never 0, where p may be 0.
  [[nodiscard]] double sample(double u) const { return end * std::pow(1 - u, 1 / (power + 1)); }

  [[nodiscard]] double pdf(double x) const {
    if (x < 0 || x > end) return 0;
    return (power + 1) * std::pow(x / end, power) / end;
  }

  [[nodiscard]] double cdf(double x) const {
    if (x < 0) return 0;
    return x > end ? 1 : std::pow(x / end, power + 1);
  }
};
// [power-density]

// [exponential-density]
/// p(x) = rate e^(-rate x) for x >= 0: how far light gets in fog.
struct ExponentialDensity {
  double rate = 1;  ///< positive

  /// 1 - u is never 0 because u is never 1: the logarithm is finite.
  [[nodiscard]] double sample(double u) const { return -std::log(1 - u) / rate; }

  [[nodiscard]] double pdf(double x) const { return x < 0 ? 0 : rate * std::exp(-rate * x); }

  [[nodiscard]] double cdf(double x) const { return x < 0 ? 0 : -std::expm1(-rate * x); }
};
// [exponential-density]

static_assert(Density<PowerDensity>);
static_assert(Density<ExponentialDensity>);

}  // namespace lt
