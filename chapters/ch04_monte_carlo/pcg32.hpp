/// @file
/// The course's source of random numbers.
#pragma once

#include <cstdint>

#include "ch04_monte_carlo/unit_float.hpp"
#include "common/math.hpp"

namespace lt {

// [pcg32]
/// PCG32 (O'Neill 2014, XSH-RR 64/32): 2^64 numbers until it repeats, and 2^63 different sequences.
class Pcg32 {
 public:
  // [pcg32-step]
  /// @param seed      where in the sequence to start
  /// @param sequence  which one; only its lower 63 bits count
  constexpr explicit Pcg32(std::uint64_t seed, std::uint64_t sequence = 0)
      : increment_(sequence << 1 | 1) {
    next_bits();
    state_ += seed;
    next_bits();
  }

  /// 32 random bits.
  constexpr std::uint32_t next_bits() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005u + increment_;
    const auto mixed = static_cast<std::uint32_t>((old >> 18 ^ old) >> 27);
    const auto turn = static_cast<std::uint32_t>(old >> 59);
    return mixed >> turn | mixed << (-turn & 31);
  }
  // [pcg32-step]

  /// Uniform in [0, 1).
  constexpr float next_float() { return unit_float(next_bits()); }

  /// Two numbers, each uniform in [0, 1), x drawn first.
  vec2 next_vec2() {
    const float x = next_float();  // one draw per statement: C++ leaves the order of arguments open
    const float y = next_float();
    return {x, y};
  }

  /// Three numbers, each uniform in [0, 1), in the order x, y, z.
  vec3 next_vec3() {
    const vec2 xy = next_vec2();
    const float z = next_float();
    return {xy, z};
  }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};
// [pcg32]

}  // namespace lt
