/// @file
/// The ground: an endless horizontal plane.
#pragma once

#include <optional>

#include "ch02_ray_casting/ray.hpp"

namespace lt {

/// The plane y = level.
struct Ground {
  float level;  ///< its y, metres
};

// [intersect-ground]
/// Distance to the ground, from above or below.
/// @param t_max  a crossing at t >= t_max does not count
/// @return t in (0, t_max), or nothing
[[nodiscard]] inline std::optional<float> intersect(const Ground& ground, const Ray& ray,
                                                    float t_max) {
  // Level rays divide by zero: t is infinite or NaN, and the comparison rejects both.
  const float t = (ground.level - ray.origin.y) / ray.direction.y;
  if (t > 0.0f && t < t_max) return t;
  return std::nullopt;
}
// [intersect-ground]

}  // namespace lt
