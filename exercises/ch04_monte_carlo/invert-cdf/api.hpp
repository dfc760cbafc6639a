/// @file
/// Exercise 04.4: what you write and what the checker calls.
#pragma once

#include "common/testkit/not_written.hpp"

namespace exercise {

// Two densities: p(x) = 3 x^2 for x from 0 to 1, and p(x) = e^-x for x >= 0. Elsewhere both are 0.

/// A number with the density 3 x^2, if u is uniform.
/// @param u  in [0, 1): may be 0
/// @return where the density is finite and not 0
[[nodiscard]] double sample_parabola(double u);

/// The density 3 x^2 from 0 to 1.
/// @param x  any
[[nodiscard]] double parabola_pdf(double x);

/// A number with the density e^-x, if u is uniform.
/// @param u  in [0, 1): may be 0
/// @return where the density is finite and not 0
[[nodiscard]] double sample_exponential(double u);

/// The density e^-x from 0 on.
/// @param x  any
[[nodiscard]] double exponential_pdf(double x);

}  // namespace exercise
