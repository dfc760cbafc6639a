/// @file
/// Exercise 04.2: what you write and what the checker calls.
#pragma once

#include <cstdint>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// The chapter's generator. The same seed and sequence give the same numbers.
class Pcg32 {
 public:
  /// @param seed      where in the sequence to start
  /// @param sequence  which one of 2^63; the highest bit does not count
  explicit Pcg32(std::uint64_t seed, std::uint64_t sequence = 0) : increment_(sequence << 1 | 1) {
    next_bits();
    state_ += seed;
    next_bits();
  }

  std::uint32_t next_bits() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005u + increment_;
    const auto mixed = static_cast<std::uint32_t>((old >> 18 ^ old) >> 27);
    const auto turn = static_cast<std::uint32_t>(old >> 59);
    return mixed >> turn | mixed << (-turn & 31);
  }

  /// Uniform in [0, 1).
  float next_float() { return static_cast<float>(next_bits() >> 8) * 0x1p-24f; }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

/// The random numbers of one sample of one pixel: a function of the four arguments and nothing
/// else.
/// @param seed    the picture's, any
/// @param x, y    pixel, 0 to 65535
/// @param sample  number of the sample within its pixel, >= 0
[[nodiscard]] Pcg32 stream_for(std::uint64_t seed, int x, int y, int sample);

}  // namespace exercise
