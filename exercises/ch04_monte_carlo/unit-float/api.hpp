/// @file
/// Exercise 04.1: what you write and what the checker calls.
#pragma once

#include <cstdint>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// A random number from random bits.
/// @param bits  each of the 2^32 values equally likely
/// @return in [0, 1), never 1; one of at least 2^23 different values, all equally likely and evenly
///         spaced
[[nodiscard]] float unit_float(std::uint32_t bits);

}  // namespace exercise
