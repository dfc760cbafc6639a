#include "api.hpp"

namespace exercise {

float unit_float(std::uint32_t bits) {
  // A float holds 24 binary digits. Whoever gives it 32 lets it round, and the largest numbers are
  // rounded up to 1. Eight digits fewer, and both steps are exact.
  const std::uint32_t digits = bits >> 8;
  return static_cast<float>(digits) * 0x1p-24f;  // the largest is 1 - 2^-24
}

}  // namespace exercise
