/// @file
/// Exercise 07.1: what you write and what the checker calls.
#pragma once

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Reflected share of light that swings across the plane of the rays and the normal (s), and of
/// light that swings in it (p).
struct Reflectance {
  double s;  ///< 0 to 1
  double p;  ///< 0 to 1
};

/// Fresnel's equations for two clear media.
/// @param cos_here  cosine of the angle to the normal on the side from which one looks, 0 to 1;
///                  rounding may leave it a little above 1
/// @param n_here    index of refraction on that side, > 0
/// @param n_beyond  index of refraction on the other side, > 0
[[nodiscard]] Reflectance reflectance_dielectric(double cos_here, double n_here, double n_beyond);

/// Reflected share of light without a preferred direction of swing, 0 to 1. Parameters as above.
[[nodiscard]] double fresnel_dielectric(double cos_here, double n_here, double n_beyond);

}  // namespace exercise
