/// @file
/// Directions, more often where the cosine is large.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/math.hpp"

namespace lt {

// [disk]
/// A point of the unit disk, all equally likely.
/// @param u  each in [0, 1)
[[nodiscard]] inline vec2 uniform_disk(vec2 u) {
  const float radius = std::sqrt(u.x);
  const float phi = 2.0f * pi * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi)};
}
// [disk]

// [cosine-hemisphere]
/// A direction of the upper hemisphere with density cos(theta) / pi: a point of the disk, lifted up
/// to the sphere (Malley). Thesis eq. 18, with z for its y.
/// @param u  each in [0, 1)
/// @return unit, local frame, z in (0, 1]
[[nodiscard]] inline vec3 cosine_hemisphere(vec2 u) {
  return {uniform_disk(u), std::sqrt(1.0f - u.x)};
}

/// Its density, 1/sr.
/// @param cos_theta  z of the direction; below the horizon the density is 0
[[nodiscard]] inline float cosine_hemisphere_pdf(float cos_theta) {
  return std::max(0.0f, cos_theta) / pi;
}
// [cosine-hemisphere]

}  // namespace lt
