/// @file
/// Samples of a density that nobody can invert: throw away what lies above its curve.
#pragma once

#include <cmath>
#include <numbers>

#include "ch04_monte_carlo/pcg32.hpp"

namespace lt {

/// A number, and what it cost.
struct Accepted {
  double x;
  int darts;  ///< how many were thrown, >= 1
};

// [rejection]
/// A number of [a, b] with a density proportional to f: darts on the box around the curve of f,
/// until one sticks below it. Von Neumann 1951.
/// @param f     >= 0; its integral is `most` (b - a) times the share of darts that stick, so it
///              must not be 0 everywhere
/// @param most  no value of f is larger
template <class Function>
[[nodiscard]] Accepted sample_by_rejection(const Function& f, double a, double b, double most,
                                           Pcg32& random) {
  for (int darts = 1;; ++darts) {
    const double x = a + (b - a) * random.next_float();
    const double height = most * random.next_float();
    if (height < f(x)) return {x, darts};
  }
}
// [rejection]

// [semicircle]
/// The upper half of the unit circle.
[[nodiscard]] inline double semicircle(double x) {
  return std::sqrt(1 - x * x);
}

/// Share of the half disk's area to the left of x: no formula gives x back from it.
/// @param x  -1 to 1
[[nodiscard]] inline double semicircle_cdf(double x) {
  return 0.5 + (x * semicircle(x) + std::asin(x)) / std::numbers::pi;
}
// [semicircle]

}  // namespace lt
