/// @file
/// The triangle.
#pragma once

#include <algorithm>
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

// [edge-side]
/// On which side of the edge from `a` to `b` a ray passes: the sign of 2 d . (b x a), with `a` and
/// `b` seen from the ray's origin. Going the edge the other way gives exactly the negative, digit
/// for digit: two triangles that share an edge never both refuse a ray.
[[nodiscard]] inline float edge_side(vec3 a, vec3 b, vec3 direction) {
  return dot(cross(b - a, b + a), direction);
}
// [edge-side]

// [intersect-triangle]
/// Distance to the triangle, from either side.
/// @param t_max  a crossing at t >= t_max does not count
/// @return t in (0, t_max), or nothing
[[nodiscard]] inline std::optional<float> intersect(const Triangle& triangle, const Ray& ray,
                                                    float t_max) {
  // Parallel rays divide by zero: t is infinite or NaN, and the comparison rejects both.
  const vec3 p0 = triangle.corner(0) - ray.origin;
  const float t = dot(triangle.normal(), p0) / dot(triangle.normal(), ray.direction);
  if (!(t > 0.0f && t < t_max)) return std::nullopt;

  // Inside means: past all three edges on the same side.
  const vec3 p1 = triangle.corner(1) - ray.origin;
  const vec3 p2 = triangle.corner(2) - ray.origin;
  const float side01 = edge_side(p0, p1, ray.direction);
  const float side12 = edge_side(p1, p2, ray.direction);
  const float side20 = edge_side(p2, p0, ray.direction);
  if (std::min({side01, side12, side20}) < 0.0f && std::max({side01, side12, side20}) > 0.0f)
    return std::nullopt;
  return t;
}
// [intersect-triangle]

}  // namespace lt
