/// @file
/// Exercise 07.2: what you write and what the checker calls.
#pragma once

#include <glm/glm.hpp>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Red, green and blue.
using Rgb = glm::dvec3;

/// Fresnel's equations for a metal, whose index is complex: eta + i k. The share of light without
/// a preferred direction of swing that is reflected, 0 to 1.
/// @param cos_here  cosine of the angle to the normal, 0 to 1; rounding may leave it a little
///                  above 1
/// @param n_here    index of refraction outside the metal, > 0
/// @param eta       real part of the metal's index, > 0
/// @param k         imaginary part, the extinction coefficient, >= 0; with 0 it is clear
[[nodiscard]] double fresnel_conductor(double cos_here, double n_here, double eta, double k);

/// A metal in colour: each channel has an index of its own.
[[nodiscard]] Rgb fresnel_conductor(double cos_here, double n_here, Rgb eta, Rgb k);

}  // namespace exercise
