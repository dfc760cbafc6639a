/// @file
/// Directions, all equally likely.
#pragma once

#include <cmath>

#include "common/math.hpp"

namespace lt {

// [uniform-hemisphere]
/// A direction of the upper hemisphere, all equally likely (Archimedes: equal slices in z have
/// equal area).
/// @param u  each in [0, 1)
/// @return unit, local frame, z in (0, 1]
[[nodiscard]] inline vec3 uniform_hemisphere(vec2 u) {
  const float z = 1.0f - u.x;
  const float radius = std::sqrt(u.x * (2.0f - u.x));  // 1 - z^2, without the subtraction
  const float phi = 2.0f * pi * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

/// Its density, 1/sr.
inline constexpr float uniform_hemisphere_pdf = 1.0f / (2.0f * pi);
// [uniform-hemisphere]

}  // namespace lt
