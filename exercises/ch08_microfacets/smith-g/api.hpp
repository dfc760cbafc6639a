/// @file
/// Exercise 08.2: what you write and what the checker calls. Directions point away from the surface
/// and are given in its own frame: z along the normal. They are unit, up to rounding.
#pragma once

#include <glm/glm.hpp>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Smith's Lambda for GGX: of the facets that face `w`, the area that is hidden for each unit that
/// is seen.
/// @param alpha  width, greater than 0
/// @param w      to the eye, on either side of the surface, not level
[[nodiscard]] double smith_lambda(double alpha, glm::dvec3 w);

/// Masking: the share of the facets with the normal `h` that one sees from `w`.
/// @param h  a facet's normal, unit
/// @return 0 to 1; 0 for facets that show `w` their back, and where `w` is level (z is 0)
[[nodiscard]] double smith_g1(double alpha, glm::dvec3 w, glm::dvec3 h);

/// Masking and shadowing, height-correlated: the share of the facets that is both seen from `wo`
/// and lit from `wi`.
/// @return 0 to 1; 0 where the two are on different sides, or one of them is level
[[nodiscard]] double smith_g2(double alpha, glm::dvec3 wo, glm::dvec3 wi);

}  // namespace exercise
