// No arithmetic on whole numbers: 23 random bits become the fraction of a float whose exponent says
// "from 1 to just below 2", and 1 is taken away. They are the lower bits here; all are random.
#include "api.hpp"

#include <bit>

namespace exercise {

float unit_float(std::uint32_t bits) {
  const std::uint32_t fraction = bits & 0x7fffffu;
  const std::uint32_t exponent_of_1 = 0x3f800000u;
  return std::bit_cast<float>(exponent_of_1 | fraction) - 1.0f;
}

}  // namespace exercise
