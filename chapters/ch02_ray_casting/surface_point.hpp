/// @file
/// Where exactly a ray met an object, and how to leave again without meeting it a second time.
#pragma once

#include <algorithm>
#include <cmath>

#include "ch02_ray_casting/scene.hpp"

namespace lt {

// [surface-point]
/// A point on an object's surface.
struct SurfacePoint {
  vec3 position;
  vec3 normal;           ///< geometric, unit; outward for spheres, up for the ground
  float position_error;  ///< metres; `position` is nearer to the true surface than this
};
// [surface-point]

/// Largest absolute coordinate.
[[nodiscard]] inline float max_abs(vec3 v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// [rounding-bound]
/// Bound on how far rounding moves a point off its surface: 4 epsilon (8 roundings) of the sum of
/// all lengths that went into it.
[[nodiscard]] inline float rounding_bound(float magnitude) {
  return 4.0f * std::numeric_limits<float>::epsilon() * magnitude;
}
// [rounding-bound]

// [on-sphere]
/// The point of `sphere` nearest to `near_it`, which is the ray's idea of where they met.
[[nodiscard]] inline SurfacePoint point_on(const Sphere& sphere, vec3 near_it) {
  const vec3 normal = normalize(near_it - sphere.center);
  const vec3 position = sphere.center + sphere.radius * normal;
  const float magnitude = max_abs(position) + max_abs(sphere.center) + sphere.radius;
  return {position, normal, rounding_bound(magnitude)};
}
// [on-sphere]

/// The point of the plane of `triangle` nearest to `near_it`.
[[nodiscard]] inline SurfacePoint point_on(const Triangle& triangle, vec3 near_it) {
  const vec3 position =
      near_it - dot(near_it - triangle.corner(0), triangle.normal()) * triangle.normal();
  const float magnitude = max_abs(position) + max_abs(triangle.corner(0)) +
                          max_abs(triangle.corner(1)) + max_abs(triangle.corner(2));
  return {position, triangle.normal(), rounding_bound(magnitude)};
}

/// The point of `ground` above or below `near_it`.
[[nodiscard]] inline SurfacePoint point_on(const Ground& ground, vec3 near_it) {
  const vec3 position{near_it.x, ground.level, near_it.z};
  return {position, {0.0f, 1.0f, 0.0f}, rounding_bound(2.0f * max_abs(position))};
}

// [surface-point-of]
/// Position and normal for the winner of closest_hit(); computed once per ray.
[[nodiscard]] inline SurfacePoint surface_point(const Scene& scene, const Ray& ray, Hit hit) {
  const vec3 near_it = ray.at(hit.t);
  std::size_t i = hit.object;
  if (i < scene.spheres.size()) return point_on(scene.spheres[i], near_it);
  i -= scene.spheres.size();
  if (i < scene.triangles.size()) return point_on(scene.triangles[i], near_it);
  return point_on(scene.grounds[i - scene.triangles.size()], near_it);
}
// [surface-point-of]

// [leave]
/// A ray that leaves `point` along `direction` (unit), started a hair off the surface on the side
/// to which it goes, so that it does not hit that same surface again.
[[nodiscard]] inline Ray leave(const SurfacePoint& point, vec3 direction) {
  const float side = std::copysign(point.position_error, dot(direction, point.normal));
  return {point.position + side * point.normal, direction};
}
// [leave]

}  // namespace lt
