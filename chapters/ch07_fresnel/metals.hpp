/// @file
/// Indices of refraction of metals.
#pragma once

#include "ch01_pixels/color.hpp"

namespace lt {

// [metals]
/// A metal's complex index of refraction eta + i k, for red, green and blue.
struct Metal {
  Rgb eta;  ///< real part, > 0
  Rgb k;    ///< imaginary part, >= 0
};

/// Measured by Johnson and Christy (1972), "Optical Constants of the Noble Metals": their rows at
/// 617, 549 and 471 nm, the nearest to the colours of a screen.
inline constexpr Metal gold{{0.21f, 0.43f, 1.31f}, {3.272f, 2.455f, 1.849f}};
inline constexpr Metal silver{{0.06f, 0.06f, 0.05f}, {4.152f, 3.586f, 2.869f}};
inline constexpr Metal copper{{0.30f, 1.02f, 1.25f}, {3.205f, 2.577f, 2.483f}};
// [metals]

}  // namespace lt
