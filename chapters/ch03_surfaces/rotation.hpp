/// @file
/// Rotations as unit quaternions.
#pragma once

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "common/math.hpp"

namespace lt {

// [rotation-about]
/// The rotation by `angle` about `axis`. In our left-handed world a positive angle turns as the
/// fingers of the left hand point when its thumb points along the axis: about y, from z to x.
/// @param axis   unit
/// @param angle  radians
[[nodiscard]] inline glm::quat rotation_about(vec3 axis, float angle) {
  const float half = angle / 2.0f;  // half, because the quaternion is applied twice: q v q*
  return {std::cos(half), std::sin(half) * axis};
}
// [rotation-about]

// [rotate]
/// `v` turned by a unit quaternion: q v q*, with q = (w, r), multiplied out.
[[nodiscard]] inline vec3 rotate(const glm::quat& q, vec3 v) {
  const vec3 r(q.x, q.y, q.z);
  const vec3 t = 2.0f * cross(r, v);
  return v + q.w * t + cross(r, t);
}

/// `v` turned back: the conjugate of a unit quaternion is its inverse.
[[nodiscard]] inline vec3 rotate_back(const glm::quat& q, vec3 v) {
  return rotate(glm::conjugate(q), v);
}
// [rotate]

}  // namespace lt
