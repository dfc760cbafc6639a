/// @file
/// From a point on a shape to a point on a texture.
/// Texture coordinates as pictures are stored: u right, v *down*, (0, 0) the top left corner,
/// (1, 1) the bottom right one; beyond that the texture repeats.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>

#include "ch02_ray_casting/triangle.hpp"
#include "ch03_surfaces/rotation.hpp"

namespace lt {

// [texture-point]
/// Where on the texture, and how the texture lies there.
struct TexturePoint {
  vec2 uv;
  vec3 tangent;  ///< world direction in which u grows; any length, 0 if there is none
};
// [texture-point]

// [sphere-uv]
/// Longitude and latitude. The middle of the texture faces -z, its upper edge is the north pole.
/// @param n  unit normal in the sphere's own axes
/// @return u and v in [0, 1]
[[nodiscard]] inline vec2 sphere_uv(vec3 n) {
  const float longitude = std::atan2(n.x, -n.z);                    // -pi to pi, 0 in the middle
  const float from_pole = std::acos(std::clamp(n.y, -1.0f, 1.0f));  // 0 to pi
  return {0.5f + longitude / (2.0f * pi), from_pole / pi};
}
// [sphere-uv]

// [sphere-mapping]
/// How a texture lies on a sphere.
struct SphereMapping {
  vec2 corner1{0.0f, 0.0f};  ///< uv at the seam's left side, north pole
  vec2 corner2{1.0f, 1.0f};  ///< uv at the seam's right side, south pole; larger than corner1
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< from the sphere's own axes to the world's
};

/// @param normal  of the sphere at the point, unit, world
[[nodiscard]] inline TexturePoint texture_point(const SphereMapping& mapping, vec3 normal) {
  assert(glm::all(glm::lessThan(mapping.corner1, mapping.corner2)));
  const vec3 n = rotate_back(mapping.rotation, normal);
  const vec2 uv = glm::mix(mapping.corner1, mapping.corner2, sphere_uv(n));
  const vec3 east(-n.z, 0.0f, n.x);  // 0 at the poles, where there is no east
  return {uv, rotate(mapping.rotation, east)};
}
// [sphere-mapping]

// [triangle-mapping]
/// How a texture lies on a triangle: uv at its corners, not mirrored (clockwise, as the corners).
struct TriangleMapping {
  vec2 corner[3] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}};
};

/// @param position  on the triangle, metres
[[nodiscard]] inline TexturePoint texture_point(const TriangleMapping& mapping,
                                                const Triangle& triangle, vec3 position) {
  const vec2 b = triangle.barycentrics(position);
  const vec2 uv1 = mapping.corner[1] - mapping.corner[0];
  const vec2 uv2 = mapping.corner[2] - mapping.corner[0];
  const vec3 edge1 = triangle.corner(1) - triangle.corner(0);
  const vec3 edge2 = triangle.corner(2) - triangle.corner(0);
  assert(uv1.x * uv2.y - uv2.x * uv1.y >= 0.0f);  // mirrored
  // The mixture of the two edges along which v stays the same.
  return {mapping.corner[0] + b.x * uv1 + b.y * uv2, uv2.y * edge1 - uv1.y * edge2};
}
// [triangle-mapping]

// [ground-mapping]
/// How a texture lies on the ground: right is +x, and up on the picture is +z.
struct GroundMapping {
  vec2 corner1{0.0f, 0.0f};     ///< the part of the texture that is repeated, from here
  vec2 corner2{1.0f, 1.0f};     ///< to here; larger than corner1
  float texture_scalar = 1.0f;  ///< side of one repetition, metres, > 0
};

[[nodiscard]] inline TexturePoint texture_point(const GroundMapping& mapping, vec3 position) {
  assert(glm::all(glm::lessThan(mapping.corner1, mapping.corner2)));
  const vec2 repetitions = vec2(position.x, -position.z) / mapping.texture_scalar;
  const vec2 within = repetitions - glm::floor(repetitions);
  return {glm::mix(mapping.corner1, mapping.corner2, within), {1.0f, 0.0f, 0.0f}};
}
// [ground-mapping]

}  // namespace lt
