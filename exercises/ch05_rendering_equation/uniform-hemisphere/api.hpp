/// @file
/// Exercise 05.1: what you write and what the checker calls.
#pragma once

#include <glm/glm.hpp>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// A direction of the upper hemisphere, all equally likely.
/// @param u  two independent random numbers, each in [0, 1)
/// @return unit, in the surface's own frame: z along the normal, 0 to 1
[[nodiscard]] glm::dvec3 uniform_hemisphere(glm::dvec2 u);

/// The density with which uniform_hemisphere() gives a direction, 1/sr.
/// @param cos_theta  z of the direction, -1 to 1; what is never given has density 0
[[nodiscard]] double uniform_hemisphere_pdf(double cos_theta);

}  // namespace exercise
