/// @file
/// Exercise 08.1: what you write and what the checker calls. Vectors are given in the surface's own
/// frame: z along the normal. All is float, as in a renderer.
#pragma once

#include <glm/glm.hpp>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Area of the facets that face `h`, for each unit of surface and steradian: GGX.
/// @param alpha  width, 1e-4 to 1
/// @param h      a facet's normal, unit
/// @return 1/sr; 0 for facets that face down or sideways (z not above 0)
[[nodiscard]] float ggx_d(float alpha, glm::vec3 h);

/// The same for a brushed surface, whose facets lean farther one way than the other.
/// @param alphas  the width along x and the width along y, each 1e-4 to 1
[[nodiscard]] float brushed_ggx_d(glm::vec2 alphas, glm::vec3 h);

/// ggx_d() of the facets that mirror light from `wi` to `wo`.
/// @param wo, wi  unit, away from the surface; either may lie below it
/// @return 1/sr; 0 if no facet does it, as where `wo` and `wi` are opposite
[[nodiscard]] float ggx_d_between(float alpha, glm::vec3 wo, glm::vec3 wi);

}  // namespace exercise
