/// @file
/// A stream of random numbers for every sample of every pixel.
#pragma once

#include "ch04_monte_carlo/pcg32.hpp"

namespace lt {

// [mix]
/// A permutation of the 64-bit numbers under which neighbours look unrelated: each bit of `x` flips
/// about half of the result's. Stafford's mix 13, the finalizer of SplitMix64 (Steele, Lea, Flood
/// 2014).
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}
// [mix]

// [stream-for]
/// The random numbers of one sample: a function of seed, pixel and sample alone, so that a picture
/// comes out the same whatever thread takes which pixel, and when.
/// @param seed    the picture's
/// @param x, y    pixel, >= 0
/// @param sample  number of the sample within its pixel, >= 0
[[nodiscard]] constexpr Pcg32 stream_for(std::uint64_t seed, int x, int y, int sample) {
  const std::uint64_t pixel = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x);
  const std::uint64_t key = mix(mix(seed + 0x9e3779b97f4a7c15u) ^ pixel);
  return Pcg32(mix(key + static_cast<std::uint64_t>(sample)), key);
}
// [stream-for]

}  // namespace lt
