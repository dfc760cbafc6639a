#include "api.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::to_code;

// The standard's curve and its inverse (IEC 61966-2-1).
double encode(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}
double decode(double signal) {
  return signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4);
}

std::string gave(const std::string& light, int code, int expected) {
  return "to_code(" + light + ") gave " + std::to_string(code) + " and should give " +
         std::to_string(expected) + ".";
}

}  // namespace

TEST_CASE("light from black to white has its code") {
  const int half = to_code(0.5);
  const int nearly_black = to_code(0.001);
  // 255 * 0.5^(1/2.2) = 186.1. The standard's curve gives 187.516. Without its line,
  // 255 * (1.055 * 0.001^(1/2.4) - 0.055) = 1.1 where the line gives 3.29.
  lt::diagnose(half != 186, "gamma22", gave("0.5", half, 188));
  lt::diagnose(half != 187, "truncate", gave("0.5", half, 188));
  lt::diagnose(half != 188 || nearly_black != 1, "line-forgotten", gave("0.001", nearly_black, 3));
  CHECK(to_code(0.0) == 0);
  CHECK(to_code(0.001) == 3);
  CHECK(to_code(0.18) == 118);  // 117.65, a grey card
  CHECK(to_code(0.5) == 188);
  CHECK(to_code(1.0) == 255);
}

TEST_CASE("light that no screen can show ends at 0 or 255") {
  // The power goes on above 1: 255 * (1.055 * 2^(1/2.4) - 0.055) = 345.1, which as a byte is 89.
  const int twice_white = to_code(2.0);
  lt::diagnose(twice_white <= 255 && twice_white != 345 - 256, "not-clamped",
               gave("2", twice_white, 255));
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const int not_a_number = to_code(nan);
  const bool are_numbers_right = twice_white == 255 && to_code(-0.5) == 0;
  lt::diagnose(!are_numbers_right || not_a_number == 0, "nan-let-through",
               gave("NaN", not_a_number, 0));
  CHECK(to_code(2.0) == 255);
  CHECK(to_code(infinity) == 255);
  CHECK(to_code(-0.5) == 0);
  CHECK(to_code(-infinity) == 0);
  CHECK(to_code(nan) == 0);
}

TEST_CASE("all 256 codes survive the way to light and back") {
  for (int code = 0; code < 256; ++code)
    CHECK(to_code(decode(code / 255.0)) == code);
}

TEST_CASE("random light goes to the nearest code") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      const double linear = random.uniform() * random.uniform();
      INFO("to_code(" << linear << ") gave " << to_code(linear) << ", and 255 s is "
                      << 255.0 * encode(linear));
      // Half a code away at most; the rest is room for arithmetic in float.
      REQUIRE(std::abs(to_code(linear) - 255.0 * encode(linear)) < 0.5001);
    }
  }
  lt::measured("the darkest tenth of the light takes " + std::to_string(to_code(0.1) + 1) +
               " of the 256 codes");
}
