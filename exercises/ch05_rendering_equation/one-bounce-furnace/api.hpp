/// @file
/// Exercise 05.2: what you write and what the checker calls. Directions are unit, point away from
/// the surface and are given in its own frame: z along the normal.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// A direction that light may come from.
struct DirectionSample {
  glm::dvec3 wi;  ///< may point below the horizon
  double pdf;     ///< the density with which it was chosen, 1/sr; greater than 0
};

/// Makes a direction of two numbers in [0, 1).
using Sampler = std::function<DirectionSample(glm::dvec2 u)>;

/// Radiance that arrives from a direction, W / (m^2 sr).
using Sky = std::function<double(glm::dvec3 wi)>;

/// Lambert's BRDF, without the cosine, 1/sr: the same for all directions above the surface.
/// @param albedo  share of the light that the surface gives back, 0 to 1
/// @return 0 where wo and wi are on different sides of the surface
[[nodiscard]] double lambert(double albedo, glm::dvec3 wo, glm::dvec3 wi);

/// An estimate of the radiance that a matt surface under a sky sends towards `wo`, W / (m^2 sr).
/// @param wo  z greater than 0
/// @param us  one pair of random numbers for each direction to ask; not empty
[[nodiscard]] double reflected(double albedo, glm::dvec3 wo, const Sampler& sampler, const Sky& sky,
                               std::span<const glm::dvec2> us);

}  // namespace exercise
