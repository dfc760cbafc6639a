#include "api.hpp"

namespace exercise {

float unit_float(std::uint32_t /*bits*/) {
  TODO("turn 32 random bits into a float from 0 to just below 1");
}

}  // namespace exercise
