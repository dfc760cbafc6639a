/// @file
/// Exercise 03.2: what you write and what the checker calls.
#pragma once

#include <glm/glm.hpp>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Three unit vectors, each perpendicular to the others, with cross(tangent, bitangent) = normal.
struct Frame {
  glm::dvec3 tangent;
  glm::dvec3 bitangent;
  glm::dvec3 normal;
};

/// A frame around a normal; which way its tangent points does not matter.
/// @param normal  unit; any direction at all, (0, 0, -1) included
[[nodiscard]] Frame frame_around(glm::dvec3 normal);

/// The normal that a normal map's texel means, in the world.
/// @param code  8-bit red, green and blue, 0 to 255: along tangent, bitangent and normal
/// @return unit
[[nodiscard]] glm::dvec3 bumped_normal(const Frame& frame, glm::ivec3 code);

}  // namespace exercise
