/// @file
/// Exercise 03.3: what you write and what the checker calls.
#pragma once

#include <glm/glm.hpp>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// w + x i + y j + z k. Rotations are those of length 1.
struct Quaternion {
  float w;
  float x, y, z;
};

/// Hamilton's product a b: as a rotation, b turns first, then a.
[[nodiscard]] Quaternion product(Quaternion a, Quaternion b);

/// The rotation by `angle` (radians) about `axis` (unit).
[[nodiscard]] Quaternion about(glm::vec3 axis, float angle);

/// `v` turned by q (unit): the vector part of q v q*.
[[nodiscard]] glm::vec3 rotate(Quaternion q, glm::vec3 v);

/// `now`, turned further by `step`: unit, however many million times it is called.
[[nodiscard]] Quaternion spin(Quaternion now, Quaternion step);

/// u of a point on a sphere that has been turned by `rotation`, see exercise 03.1.
/// @param n  the sphere's normal at the point, unit, in the world
[[nodiscard]] float sphere_u(Quaternion rotation, glm::vec3 n);

}  // namespace exercise
