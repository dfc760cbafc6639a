/// @file
/// Random bits to a number in [0, 1).
#pragma once

#include <cstdint>

namespace lt {

// [unit-float]
/// 32 random bits to a float in [0, 1): never 1. Only the upper 24 bits count, as many as a float
/// holds: every multiple of 2^-24 is equally likely. (Dividing all 32 by 2^32 rounds the largest
/// ones up to exactly 1.)
[[nodiscard]] constexpr float unit_float(std::uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}
// [unit-float]

}  // namespace lt
