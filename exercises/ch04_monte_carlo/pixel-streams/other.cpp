// No number that holds a whole pixel: the bytes of all four arguments go through a hash, one after
// the other, as those of a text would (FNV-1a). Two hashes with different starts, one for each
// argument of the generator; their last bytes' effect is spread by a multiplication from above.
#include "api.hpp"

namespace exercise {

namespace {

std::uint64_t hash(std::uint64_t start, std::uint64_t seed, int x, int y, int sample) {
  std::uint64_t sum = start;
  for (const std::uint64_t number :
       {seed, static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y),
        static_cast<std::uint64_t>(sample)})
    for (int shift = 0; shift < 64; shift += 8)
      sum = (sum ^ (number >> shift & 255u)) * 0x100000001b3u;
  sum = (sum ^ sum >> 32) * 0xd6e8feb86659fd93u;
  return sum ^ sum >> 32;
}

}  // namespace

Pcg32 stream_for(std::uint64_t seed, int x, int y, int sample) {
  const std::uint64_t start = hash(0xcbf29ce484222325u, seed, x, y, sample);
  return Pcg32(start, hash(start, seed, x, y, sample));
}

}  // namespace exercise
