/// @file
/// Numbers and vectors up to rounding, compared so that a failing check shows both of them.
#pragma once

#include <cmath>
#include <concepts>
#include <string>

#include "common/testkit/catch.hpp"

namespace lt {

/// What close_to() gives.
template <class T>
struct CloseTo {
  T value;
  double tolerance;
};

/// `CHECK(v == close_to(vec3(1, 0, 0), 1e-5))` holds where `v` is no farther than `tolerance` from
/// the value (for vectors: by length), and shows "(0, 0, 1) == close to (1, 0, 0)" where it is.
/// NaN is close to nothing.
template <class T>
[[nodiscard]] CloseTo<T> close_to(T value, double tolerance = 1e-6) {
  return {value, tolerance};
}

template <std::floating_point T, std::floating_point U>
[[nodiscard]] bool operator==(T given, const CloseTo<U>& expected) {
  return std::abs(static_cast<double>(given) - static_cast<double>(expected.value)) <=
         expected.tolerance;
}

template <glm::length_t N, class T, glm::qualifier Q>
[[nodiscard]] bool operator==(const glm::vec<N, T, Q>& given,
                              const CloseTo<glm::vec<N, T, Q>>& expected) {
  return static_cast<double>(glm::distance(given, expected.value)) <= expected.tolerance;
}

}  // namespace lt

namespace Catch {

template <class T>
struct StringMaker<lt::CloseTo<T>> {
  static std::string convert(const lt::CloseTo<T>& expected) {
    return "close to " + ::Catch::Detail::stringify(expected.value);
  }
};

}  // namespace Catch
