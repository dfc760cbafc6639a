/// @file
/// Mistakes to look at: forms that are right on paper and fail in floating point. The pictures
/// `--view nan` and `--view far-naive` are made with them; nothing else uses them.
#pragma once

#include <cmath>
#include <optional>

#include "ch02_ray_casting/scene.hpp"

namespace lt::mistakes {

// [naive-discriminant]
/// Half of the school formula's b^2 - 4ac, over 2: the difference of two numbers that are nearly
/// equal when the sphere is far away.
[[nodiscard]] inline float discriminant(const Sphere& sphere, const Ray& ray) {
  const vec3 from_center = ray.origin - sphere.center;
  const float b = dot(from_center, ray.direction);
  const float k = dot(from_center, from_center) - sphere.radius * sphere.radius;
  return b * b - k;
}
// [naive-discriminant]

/// The sphere, by the school formula.
[[nodiscard]] inline std::optional<float> intersect(const Sphere& sphere, const Ray& ray,
                                                    float t_max) {
  const float root = std::sqrt(discriminant(sphere, ray));  // NaN where the ray misses
  const float b = dot(ray.origin - sphere.center, ray.direction);
  for (const float t : {-b - root, -b + root})
    if (t > 0.0f && t < t_max) return t;
  return std::nullopt;
}

// [careless-triangle]
/// The triangle, asked the wrong way round: what is not outside is inside. Every comparison with
/// NaN is false, so a ray parallel to the triangle (0/0, or 0 times infinity) "hits" it.
[[nodiscard]] inline std::optional<float> intersect(const Triangle& triangle, const Ray& ray) {
  const float t = dot(triangle.normal(), triangle.corner(0) - ray.origin) /
                  dot(triangle.normal(), ray.direction);
  const vec3 point = ray.at(t);
  const vec2 b = triangle.barycentrics(point);
  const bool is_behind = dot(point - ray.origin, ray.direction) < 0.0f;
  if (is_behind || b.x < 0.0f || b.y < 0.0f || b.x + b.y > 1.0f) return std::nullopt;
  return length(point - ray.origin);
}
// [careless-triangle]

[[nodiscard]] inline std::optional<float> intersect(const Sphere& sphere, const Ray& ray) {
  return lt::intersect(sphere, ray, infinity);
}

[[nodiscard]] inline std::optional<float> intersect(const Ground& ground, const Ray& ray) {
  return lt::intersect(ground, ray, infinity);
}

/// The distance to object number `object`, found anew each time.
[[nodiscard]] inline std::optional<float> distance_to(const Scene& scene, std::uint32_t object,
                                                      const Ray& ray) {
  std::size_t i = object;
  if (i < scene.spheres.size()) return intersect(scene.spheres[i], ray);
  i -= scene.spheres.size();
  if (i < scene.triangles.size()) return intersect(scene.triangles[i], ray);
  return intersect(scene.grounds[i - scene.triangles.size()], ray);
}

// [every-pair]
/// The closest hit as the thesis' program finds it: an object is the closest if no other object is
/// closer. n objects ask n objects: O(n^2). And nothing is closer than NaN.
[[nodiscard]] inline std::optional<Hit> closest_hit(const Scene& scene, const Ray& ray) {
  std::optional<Hit> closest;
  for (std::uint32_t i = 0; i < scene.object_count(); ++i) {
    const auto t = distance_to(scene, i, ray);
    bool is_closest = t.has_value();
    for (std::uint32_t j = 0; j < scene.object_count(); ++j) {
      const auto other = distance_to(scene, j, ray);
      if (t && other && *other < *t) is_closest = false;
    }
    if (is_closest) closest = Hit{*t, i};
  }
  return closest;
}
// [every-pair]

}  // namespace lt::mistakes
