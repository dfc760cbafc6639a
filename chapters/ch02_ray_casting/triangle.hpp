/// @file
/// The triangle.
#pragma once

#include <optional>

#include "ch02_ray_casting/ray.hpp"

namespace lt {

// [triangle]
/// Corners clockwise as seen from the side to which the normal points (left-handed world).
/// What does not depend on the ray is computed once, here.
class Triangle {
 public:
  /// @param p0, p1, p2  corners in metres, not on one line
  Triangle(vec3 p0, vec3 p1, vec3 p2) : corners_{p0, p1, p2} {
    const vec3 n = cross(p1 - p0, p2 - p0);
    normal_ = normalize(n);
    b1_axis_ = cross(p2 - p0, n) / dot(n, n);
    b2_axis_ = cross(n, p1 - p0) / dot(n, n);
  }

  [[nodiscard]] vec3 corner(int i) const { return corners_[i]; }
  [[nodiscard]] vec3 normal() const { return normal_; }

  /// Barycentric weights of corners 1 and 2 at `point`; corner 0 has the rest, 1 - b1 - b2.
  [[nodiscard]] vec2 barycentrics(vec3 point) const {
    const vec3 from_corner = point - corners_[0];
    return {dot(b1_axis_, from_corner), dot(b2_axis_, from_corner)};
  }

 private:
  vec3 corners_[3];
  vec3 normal_;
  vec3 b1_axis_;  ///< dual to the edge to corner 1: 1 along it, 0 along the other edge
  vec3 b2_axis_;
};
// [triangle]

/// How far outside, in barycentric weight, still counts as inside: neighbours overlap by a hair, so
/// that no ray slips between two triangles that share an edge.
inline constexpr float edge_tolerance = 1e-6f;

// [intersect-triangle]
/// Distance to the triangle, from either side.
/// @return t in (0, t_max), or nothing
[[nodiscard]] inline std::optional<float> intersect(const Triangle& triangle, const Ray& ray,
                                                    float t_max) {
  // Parallel rays divide by zero: t is infinite or NaN, and both comparisons below reject it.
  const float t = dot(triangle.normal(), triangle.corner(0) - ray.origin) /
                  dot(triangle.normal(), ray.direction);
  if (!(t > 0.0f && t < t_max)) return std::nullopt;

  const vec2 b = triangle.barycentrics(ray.at(t));
  if (b.x < -edge_tolerance || b.y < -edge_tolerance || b.x + b.y > 1.0f + edge_tolerance)
    return std::nullopt;
  return t;
}
// [intersect-triangle]

}  // namespace lt
