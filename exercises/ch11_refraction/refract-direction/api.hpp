/// @file
/// Exercise 11.1: what you write and what the checker calls. Directions are unit and point away
/// from the surface.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Where a ray goes on behind the surface of a clear object (Snell).
/// @param wo         to where the ray came from, from either side of the surface, not along it
/// @param normal     of the surface, out of the object; unit
/// @param n_outside  index of refraction outside the object, greater than 0
/// @param n_inside   index of refraction of the object, greater than 0
/// @return unit, away from the surface, on the other side than wo; nothing where all light is
///         reflected
[[nodiscard]] std::optional<glm::dvec3> refracted(glm::dvec3 wo, glm::dvec3 normal,
                                                  double n_outside, double n_inside);

}  // namespace exercise
