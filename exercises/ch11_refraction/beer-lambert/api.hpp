/// @file
/// Exercise 11.4: what you write and what the checker calls. Lengths are in metres.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Red, green and blue of a factor or of an attenuation.
using Rgb = glm::dvec3;

/// A point at which a path has met a surface.
struct Vertex {
  glm::dvec3 position;  ///< metres
  bool outside;         ///< the path came to it from outside the object
  Rgb attenuation;      ///< of the object's inside, 1/m
};

/// The share of light that is left after a straight way through a medium (Beer and Lambert).
/// @param attenuation  1/m, 0 or more
/// @param distance     metres, 0 or more
[[nodiscard]] Rgb transmittance(Rgb attenuation, double distance);

/// The same for a ray that comes from the medium of index `n_here`, enters a flat pane and crosses
/// it once. Reflection is left out.
/// @param thickness  of the pane, metres
/// @param cos_here   cosine of the ray's angle to the pane's normal before it enters, 0 to 1
/// @param n_here     index of refraction outside
/// @param n_beyond   index of refraction of the pane, at least n_here
[[nodiscard]] Rgb pane_transmittance(Rgb attenuation, double thickness, double cos_here,
                                     double n_here, double n_beyond);

/// The share of light that is left along a path of straight segments from the camera through all
/// vertices. Objects are closed and do not overlap; air takes nothing away.
[[nodiscard]] Rgb path_transmittance(glm::dvec3 camera, std::span<const Vertex> path);

}  // namespace exercise
