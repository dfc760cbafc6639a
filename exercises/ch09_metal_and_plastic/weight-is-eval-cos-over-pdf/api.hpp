/// @file
/// Exercise 09.2: what you write and what the checker calls. Directions are unit, point away from
/// the surface and are given in its own frame: z along the normal.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// From the cosine of the angle at a facet, 0 to 1, to the share that the facet reflects.
using Fresnel = std::function<double(double cosine)>;

/// D, G and a facet by chance, as in exercises 08.1, 08.2 and 09.1. They are there.
/// @param wo, wi, h  z greater than 0
[[nodiscard]] double ggx_d(double alpha, glm::dvec3 h);
[[nodiscard]] double smith_g2(double alpha, glm::dvec3 wo, glm::dvec3 wi);
[[nodiscard]] glm::dvec3 sample_facet(double alpha, glm::dvec2 u);

/// A direction that a rough mirror proposes.
struct Sample {
  glm::dvec3 wi;  ///< z greater than 0
  double weight;  ///< f times the cosine of wi, over pdf
  double pdf;     ///< density of wi, 1/sr
};

/// Lets the facet that sample_facet() gives for `u` mirror `wo`.
/// @param wo  z greater than 0
/// @return nothing where that is not above the surface
[[nodiscard]] std::optional<Sample> ggx_sample(double alpha, const Fresnel& fresnel, glm::dvec3 wo,
                                               glm::dvec2 u);

}  // namespace exercise
