/// @file
/// Frames: three unit vectors at a right angle to each other, one of them the normal.
#pragma once

#include <cmath>

#include "common/math.hpp"

namespace lt {

// [frame]
/// Axes of a point on a surface. Each is unit, each is perpendicular to the others, and
/// cross(tangent, bitangent) is the normal. Local coordinates are (x, y, z) along the three.
struct Frame {
  vec3 tangent;    ///< where there is a texture: along +u, to the right
  vec3 bitangent;  ///< along +v, down
  vec3 normal;

  /// A direction given in local coordinates, in the world.
  [[nodiscard]] vec3 to_world(vec3 local) const {
    return local.x * tangent + local.y * bitangent + local.z * normal;
  }
  /// A direction given in the world, in local coordinates.
  [[nodiscard]] vec3 to_local(vec3 world) const {
    return {dot(world, tangent), dot(world, bitangent), dot(world, normal)};
  }
};
// [frame]

// [frame-around]
/// A frame around `normal` (unit) where nobody cares which way the tangent points. Without a case
/// that divides by zero: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
[[nodiscard]] inline Frame frame_around(vec3 normal) {
  const float s = std::copysign(1.0f, normal.z);
  const float a = -1.0f / (s + normal.z);  // s + z lies beyond 1 or -1, whatever z is
  const float b = normal.x * normal.y * a;
  return {{1.0f + s * normal.x * normal.x * a, s * b, -s * normal.x},
          {b, s + normal.y * normal.y * a, -normal.y},
          normal};
}
// [frame-around]

// [frame-along]
/// The frame around `normal` (unit) whose tangent is the nearest to `tangent` (Gram-Schmidt).
/// @param tangent  any length; where it is 0 or along the normal, any tangent will do
[[nodiscard]] inline Frame frame_along(vec3 normal, vec3 tangent) {
  const vec3 in_plane = tangent - dot(tangent, normal) * normal;
  const float squared_length = dot(in_plane, in_plane);
  if (!(squared_length > 1e-10f * dot(tangent, tangent))) return frame_around(normal);
  const vec3 unit = in_plane / std::sqrt(squared_length);
  return {unit, cross(normal, unit), normal};
}
// [frame-along]

// [seen-from-behind]
/// The same frame for someone behind the surface: the normal turns round, and so must one tangent,
/// or the frame would be its own mirror image.
[[nodiscard]] inline Frame seen_from_behind(const Frame& frame) {
  return {frame.tangent, -frame.bitangent, -frame.normal};
}
// [seen-from-behind]

}  // namespace lt
