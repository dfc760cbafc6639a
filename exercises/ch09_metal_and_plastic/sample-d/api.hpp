/// @file
/// Exercise 09.1: what you write and what the checker calls. Directions are unit, point away from
/// the surface and are given in its own frame: z along the normal.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// D, as in exercise 08.1. It is there: you need not write it.
/// @param h  unit, z greater than 0
[[nodiscard]] double ggx_d(double alpha, glm::dvec3 h);

/// A facet's normal, likely in proportion to D(h) times the cosine of h.
/// @param u  two independent random numbers, each in [0, 1)
/// @return unit, z greater than 0
[[nodiscard]] glm::dvec3 sample_facet(double alpha, glm::dvec2 u);

/// The density with which sample_facet() gives `h`, 1/sr.
/// @param h  unit, z greater than 0
[[nodiscard]] double facet_pdf(double alpha, glm::dvec3 h);

/// The direction to which such a facet mirrors `wo`.
/// @param wo  z greater than 0
/// @return nothing where that is not above the surface
[[nodiscard]] std::optional<glm::dvec3> sample_wi(double alpha, glm::dvec3 wo, glm::dvec2 u);

/// The density with which sample_wi() gives `wi`, 1/sr.
/// @param wi  anywhere; what is never given has density 0
[[nodiscard]] double wi_pdf(double alpha, glm::dvec3 wo, glm::dvec3 wi);

}  // namespace exercise
