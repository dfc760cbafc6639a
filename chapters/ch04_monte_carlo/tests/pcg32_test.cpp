#include "ch04_monte_carlo/pcg32.hpp"

#include <array>
#include <vector>

#include "ch04_monte_carlo/mistakes.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;

namespace {

// Printed by the PCG library's pcg32-demo, round 1: seeded with pcg32_srandom(42, 54).
constexpr std::array<std::uint32_t, 6> published{0xa15c02b7, 0x7b47f409, 0xba1d3330,
                                                 0x83d2f293, 0xbfa4784b, 0xcbed606e};

constexpr bool gives_published_numbers() {
  Pcg32 random(42, 54);
  for (const std::uint32_t number : published)
    if (random.next_bits() != number) return false;
  return true;
}

// The definition again, without 64-bit arithmetic: numbers of four 16-bit digits, lowest first.
using Digits = std::array<std::uint32_t, 4>;

Digits digits_of(std::uint64_t x) {
  Digits digits;
  for (int i = 0; i < 4; ++i)
    digits[i] = static_cast<std::uint32_t>(x >> 16 * i & 0xffff);
  return digits;
}

// a b + c, as at school; what would be a fifth digit is dropped.
Digits multiply_add(const Digits& a, const Digits& b, const Digits& c) {
  Digits result{};
  for (int i = 0; i < 4; ++i) {
    std::uint32_t carry = 0;
    for (int j = 0; i + j < 4; ++j) {
      const std::uint32_t sum = a[i] * b[j] + result[i + j] + carry;
      result[i + j] = sum & 0xffff;
      carry = sum >> 16;
    }
  }
  std::uint32_t carry = 0;
  for (int i = 0; i < 4; ++i) {
    const std::uint32_t sum = result[i] + c[i] + carry;
    result[i] = sum & 0xffff;
    carry = sum >> 16;
  }
  return result;
}

bool bit(const Digits& x, int i) {
  return i < 64 && (x[i / 16] >> i % 16 & 1) != 0;
}

// O'Neill 2014, section 6.3: bits 27 to 58 of (state >> 18) ^ state, turned right by the number in
// the five highest bits.
std::uint32_t output_of(const Digits& state) {
  const std::uint32_t turn = state[3] >> 11;
  std::uint32_t result = 0;
  for (std::uint32_t i = 0; i < 32; ++i) {
    const int from = 27 + static_cast<int>((i + turn) % 32);
    if (bit(state, from) != bit(state, from + 18)) result |= 1u << i;
  }
  return result;
}

}  // namespace

static_assert(gives_published_numbers());

TEST_CASE("PCG32: the numbers that the PCG library's demonstration prints") {
  Pcg32 random(42, 54);
  for (const std::uint32_t number : published)
    CHECK(random.next_bits() == number);
}

TEST_CASE("PCG32: agrees with the definition worked out in 16-bit digits") {
  const Digits multiplier = digits_of(6364136223846793005u);
  Pcg32 seeds(1);
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t seed = std::uint64_t{seeds.next_bits()} << 32 | seeds.next_bits();
    const std::uint64_t sequence = std::uint64_t{seeds.next_bits()} << 31 | seeds.next_bits();
    const Digits increment = digits_of(2 * sequence + 1);
    // pcg32_srandom: one step from 0, add the seed, one step.
    Digits state = multiply_add(digits_of(1), increment, digits_of(seed));
    state = multiply_add(state, multiplier, increment);
    Pcg32 random(seed, sequence);
    for (int draw = 0; draw < 100; ++draw) {
      REQUIRE(random.next_bits() == output_of(state));
      state = multiply_add(state, multiplier, increment);
    }
  }
}

TEST_CASE("PCG32: copies go on alike, seeds and sequences do not") {
  Pcg32 random(1, 2);
  random.next_bits();
  Pcg32 copy = random;
  CHECK(copy.next_bits() == random.next_bits());
  CHECK(Pcg32(1, 2).next_bits() != Pcg32(2, 2).next_bits());
  CHECK(Pcg32(1, 2).next_bits() != Pcg32(1, 3).next_bits());
}

TEST_CASE("PCG32: x is drawn before y before z, whatever the compiler") {
  Pcg32 one(5);
  Pcg32 other(5);
  const float x = one.next_float();
  const float y = one.next_float();
  const float z = one.next_float();
  CHECK(other.next_vec3() == vec3(x, y, z));
  Pcg32 third(5);
  CHECK(third.next_vec2() == vec2(x, y));
  CHECK(z == unit_float(third.next_bits()));
}

TEST_CASE("PCG32, a mistake: two draws in one argument list come in either order") {
  Pcg32 right(5);
  Pcg32 wrong(5);
  const vec2 xy = right.next_vec2();
  const vec2 drawn = mistakes::next_vec2(wrong);
  CHECK((drawn == xy || drawn == vec2(xy.y, xy.x)));  // g++: the latter; clang: the former
}

TEST_CASE("PCG32: moments of a uniform number are 1/2, 1/3, 1/4, and its variance is 1/12") {
  Pcg32 random(8);
  RunningMean first, second, third;
  for (int i = 0; i < 1'000'000; ++i) {
    const double u = random.next_float();
    first.add(u);
    second.add(u * u);
    third.add(u * u * u);
  }
  CHECK(z_test(first, 1.0 / 2).agrees());
  CHECK(z_test(second, 1.0 / 3).agrees());
  CHECK(z_test(third, 1.0 / 4).agrees());
  CHECK(first.variance() == Approx(1.0 / 12).epsilon(0.005));  // its error: 0.09 %
}

TEST_CASE("PCG32: uniform, and pairs of neighbours fill the square") {
  Pcg32 random(9);
  std::vector<double> samples;
  for (int i = 0; i < 100'000; ++i)
    samples.push_back(random.next_float());
  const auto cdf = [](double x) { return x; };
  CHECK(kolmogorov_smirnov(samples, cdf).p_value > 1e-6);

  constexpr int side = 64;
  constexpr int pairs = 1'000'000;
  std::vector<double> counts(side * side);
  for (int i = 0; i < pairs; ++i) {
    const ivec2 cell(random.next_vec2() * static_cast<float>(side));
    ++counts[static_cast<std::size_t>(cell.y * side + cell.x)];
  }
  const std::vector<double> expected(counts.size(), 1.0 * pairs / (side * side));
  CHECK(chi_square(counts, expected).p_value > 1e-6);
}
