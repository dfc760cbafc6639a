/// @file
/// Exercise 09.3: what you write and what the checker calls. Directions are unit, point away from
/// the surface and are given in its own frame: z along the normal.
#pragma once

#include <glm/glm.hpp>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// D, as in exercise 08.1. It is there, as are G1 and G2: you need not write them.
/// @param h  z not below 0
[[nodiscard]] double ggx_d(double alpha, glm::dvec3 h);
/// The share that one sees along `w`, of facets that face it.
/// @param w  z greater than 0
[[nodiscard]] double smith_g1(double alpha, glm::dvec3 w);
/// The share that is both seen along `wo` and lit along `wi`; 0 where `wi` is not above.
[[nodiscard]] double smith_g2(double alpha, glm::dvec3 wo, glm::dvec3 wi);

/// A facet's normal, likely in proportion to what one sees of its kind along `wo`.
/// @param wo  z greater than 0
/// @param u   two independent random numbers, each in [0, 1)
/// @return unit; it faces up, and it faces `wo`
[[nodiscard]] glm::dvec3 sample_visible(double alpha, glm::dvec3 wo, glm::dvec2 u);

/// The density with which sample_visible() gives `h`, 1/sr.
/// @param h  z not below 0; what shows `wo` its back has density 0
[[nodiscard]] double visible_pdf(double alpha, glm::dvec3 wo, glm::dvec3 h);

/// What the direction to which such a facet mirrors `wo` counts, where facets reflect all light:
/// f times the cosine of `wi`, over the density of `wi`.
/// @return 0 where `wi` is not above
[[nodiscard]] double visible_weight(double alpha, glm::dvec3 wo, glm::dvec3 wi);

}  // namespace exercise
