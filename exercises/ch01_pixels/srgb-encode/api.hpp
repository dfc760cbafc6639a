/// @file
/// Exercise 01.1: what you write and what the checker calls.
#pragma once

#include "common/testkit/not_written.hpp"

namespace exercise {

/// The 8-bit sRGB code nearest to a linear value.
/// @param linear  light, 1 = white; any number at all, NaN included
/// @return 0 to 255; too bright gives 255, negative and NaN give 0
[[nodiscard]] int to_code(double linear);

}  // namespace exercise
