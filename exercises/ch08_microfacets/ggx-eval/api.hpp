/// @file
/// Exercise 08.3: what you write and what the checker calls. Directions are unit, point away from
/// the surface and are given in its own frame: z along the normal.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// From the cosine of the angle at a facet, 0 to 1, to the share that the facet reflects.
using Fresnel = std::function<double(double cosine)>;

/// D, as in exercise 08.1. It is there: you need not write it.
/// @param h  unit, z greater than 0
[[nodiscard]] double ggx_d(double alpha, glm::dvec3 h);

/// G, as in exercise 08.2. It is there too.
/// @param wo, wi  z greater than 0: it does not ask for the side
[[nodiscard]] double smith_g2(double alpha, glm::dvec3 wo, glm::dvec3 wi);

/// The normal of the facets that mirror `wi` to `wo`.
/// @return unit; (0, 0, 0) where the two are opposite
[[nodiscard]] glm::dvec3 half_vector(glm::dvec3 wo, glm::dvec3 wi);

/// The BRDF of a rough mirror, without the cosine, 1/sr.
/// @return 0 unless both directions are above the surface (z greater than 0)
[[nodiscard]] double ggx_eval(double alpha, const Fresnel& fresnel, glm::dvec3 wo, glm::dvec3 wi);

}  // namespace exercise
