#include "api.hpp"

namespace exercise {

namespace {

// Neighbours in, strangers out: each bit of x changes about half of the result's. No two x give the
// same. (Stafford's mix 13, which ends SplitMix64.)
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}

}  // namespace

Pcg32 stream_for(std::uint64_t seed, int x, int y, int sample) {
  // x and y side by side in one number: no two pixels share it, whatever the picture's width.
  const std::uint64_t pixel = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x);

  // Mixed after every step. In a plain sum, seed 1 with sample 2 would be seed 2 with sample 1.
  const std::uint64_t key = mix(mix(seed + 0x9e3779b97f4a7c15u) ^ pixel);
  const std::uint64_t start = mix(key + static_cast<std::uint64_t>(sample));
  return Pcg32(start, key);
}

}  // namespace exercise
