#include "ch04_monte_carlo/unit_float.hpp"

#include <cmath>
#include <vector>

#include "ch04_monte_carlo/densities.hpp"
#include "ch04_monte_carlo/mistakes.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

// The smallest and the largest: 0 and 1 - 2^-24, the float just below 1.
static_assert(unit_float(0) == 0.0f);
static_assert(unit_float(0xffffffffu) == 1.0f - 0x1p-24f);

TEST_CASE("unit float: all ones are the largest float below 1") {
  CHECK(unit_float(0xffffffffu) == std::nextafter(1.0f, 0.0f));
  CHECK(unit_float(0x80000000u) == 0.5f);
  CHECK(unit_float(0xffu) == 0.0f);  // the lower eight bits do not count
  CHECK(unit_float(0x100u) == 0x1p-24f);
}

TEST_CASE("unit float: never 1 and never falling, wherever the rounding could change") {
  float before = 0.0f;
  for (std::uint64_t bits = 0; bits < 0x100000000u; bits += 0x7fff) {
    const float u = unit_float(static_cast<std::uint32_t>(bits));
    REQUIRE((u >= before && u < 1.0f));
    before = u;
  }
  for (std::uint32_t below = 0; below < 1000; ++below)
    REQUIRE(unit_float(0xffffffffu - below) < 1.0f);
}

TEST_CASE("unit float, a mistake: bits by 2^32 are exactly 1 for the largest 128 of them") {
  // Floats below 1 are 2^-24 apart: from halfway, 1 - 2^-25, up, a number is rounded to 1 (at
  // halfway too, since 1 is even). In 32 bits that is 2^32 - 2^7.
  CHECK(mistakes::unit_float(0xffffffffu) == 1.0f);
  CHECK(mistakes::unit_float(0xffffff80u) == 1.0f);
  CHECK(mistakes::unit_float(0xffffff7fu) < 1.0f);
  // What it leads to: light that travels infinitely far.
  CHECK(std::isinf(ExponentialDensity{}.sample(mistakes::unit_float(0xffffffffu))));
  CHECK(std::isfinite(ExponentialDensity{}.sample(unit_float(0xffffffffu))));
}

TEST_CASE("unit float: 256 bins fill evenly") {
  constexpr int samples = 1 << 20;
  std::vector<double> counts(256);
  Pcg32 random(3);
  for (int i = 0; i < samples; ++i)
    ++counts[static_cast<std::size_t>(random.next_float() * 256.0f)];
  const std::vector<double> expected(256, samples / 256.0);
  CHECK(chi_square(counts, expected).p_value > 1e-6);
}
