/// @file
/// The sphere.
#pragma once

#include <cmath>
#include <optional>

#include "ch02_ray_casting/ray.hpp"

namespace lt {

/// A ball's surface; it can be hit from outside and from inside.
struct Sphere {
  vec3 center;   ///< metres
  float radius;  ///< metres, > 0
};

// [intersect-sphere]
/// Distance to the nearest crossing of the surface, from outside or inside.
/// @param t_max  crossings at t >= t_max do not count
/// @return t in (0, t_max), or nothing
/// Stable form of the quadratic: Haines et al. 2019, Ray Tracing Gems ch. 7.
[[nodiscard]] inline std::optional<float> intersect(const Sphere& sphere, const Ray& ray,
                                                    float t_max) {
  const vec3 from_center = ray.origin - sphere.center;
  const float b = dot(from_center, ray.direction);
  const vec3 closest = from_center - b * ray.direction;  // the line's nearest point to the center
  const float discriminant = sphere.radius * sphere.radius - dot(closest, closest);
  if (discriminant < 0.0f) return std::nullopt;

  // Two roots: q, and k / q, which does not subtract nearly equal numbers.
  const float q = -b - std::copysign(std::sqrt(discriminant), b);
  const float k = dot(from_center, from_center) - sphere.radius * sphere.radius;
  const float near = std::fmin(q, k / q);
  const float far = std::fmax(q, k / q);
  const float t = near > 0.0f ? near : far;
  if (t > 0.0f && t < t_max) return t;
  return std::nullopt;
}
// [intersect-sphere]

}  // namespace lt
