/// @file
/// Three integrals that are known, to see whether chance finds them.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace lt {

// [integrals]
/// An integral with its exact value.
struct KnownIntegral {
  std::string name;
  double (*f)(double x);
  double a, b;  ///< the ends
  double exact;
};

/// A smooth bump.
[[nodiscard]] inline KnownIntegral sine() {
  return {"sine", [](double x) { return std::sin(x); }, 0, std::numbers::pi, 2};
}

/// The thesis' formula 12 is tried on it.
[[nodiscard]] inline KnownIntegral parabola() {
  return {"parabola", [](double x) { return x * x; }, 0, 2, 8.0 / 3};
}

/// Light, then the edge of a shadow.
[[nodiscard]] inline KnownIntegral edge() {
  return {"edge", [](double x) { return x < 1.0 / 3 ? 1.0 : 0.0; }, 0, 1, 1.0 / 3};
}
// [integrals]

[[nodiscard]] inline std::array<KnownIntegral, 3> known_integrals() {
  return {sine(), parabola(), edge()};
}

}  // namespace lt
