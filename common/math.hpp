/// @file
/// The few names from GLM that every chapter uses, and three constants.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace lt {

using glm::cross;
using glm::dot;
using glm::ivec2;
using glm::mat3;
using glm::normalize;
using glm::vec2;
using glm::vec3;

inline constexpr float pi = 3.14159265358979323846f;
inline constexpr float infinity = std::numeric_limits<float>::infinity();

/// Degrees to radians.
[[nodiscard]] constexpr float radians(float degrees) {
  return degrees * (pi / 180.0f);
}

}  // namespace lt
