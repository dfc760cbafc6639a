#include "ch04_monte_carlo/streams.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ch04_monte_carlo/mistakes.hpp"
#include "ch04_monte_carlo/photons.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;

namespace {

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;

// All draws of a few hundred streams in one number.
constexpr std::uint64_t digest() {
  std::uint64_t sum = 0;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      for (int sample = 0; sample < 4; ++sample) {
        Pcg32 random = stream_for(1, x, y, sample);
        for (int draw = 0; draw < 4; ++draw)
          sum = mix(sum ^ random.next_bits());
      }
  return sum;
}

// Correlation of two lists of uniform numbers.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (a[i] - 0.5) * (b[i] - 0.5);
  return 12 * sum / static_cast<double>(a.size());
}

// The mean of `samples` first draws, for each pixel of a square of this side, as a number whose
// variance is 1/12.
std::vector<double> means(StreamOf stream_of, int side, int samples) {
  std::vector<double> pixels;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      double sum = 0;
      for (int sample = 0; sample < samples; ++sample)
        sum += stream_of(1, x, y, sample).next_float() - 0.5;
      pixels.push_back(0.5 + sum / std::sqrt(samples));
    }
  return pixels;
}

// The largest correlation of pixels with those up to four to the right and up to two below.
double largest_neighbour_correlation(StreamOf stream_of, int side, int samples) {
  const std::vector<double> pixels = means(stream_of, side, samples);
  double largest = 0;
  for (int dy = 0; dy <= 2; ++dy)
    for (int dx = dy == 0 ? 1 : -4; dx <= 4; ++dx) {
      std::vector<double> here, there;
      for (int y = 0; y + dy < side; ++y)
        for (int x = 4; x + 4 < side; ++x) {
          here.push_back(pixels[static_cast<std::size_t>(y * side + x)]);
          there.push_back(pixels[static_cast<std::size_t>((y + dy) * side + x + dx)]);
        }
      largest = std::max(largest, std::abs(correlation(here, there)));
    }
  return largest;
}

}  // namespace

// SplitMix64 seeded with 1234567 is mix() of multiples of the golden ratio; its first numbers are
// printed at Rosetta Code, "Pseudo-random numbers/Splitmix64".
static_assert(mix(1234567 + golden) == 6457827717110365317u);
static_assert(mix(1234567 + 2 * golden) == 3203168211198807973u);
static_assert(mix(1234567 + 3 * golden) == 9817491932198370423u);

TEST_CASE("streams: the same numbers with every compiler, optimised or not") {
  // Worked out from the definitions with Python's integers, which have no size to overflow.
  static_assert(digest() == 0x1fb86d7b152f73c0u);
  CHECK(digest() == 0x1fb86d7b152f73c0u);
  Pcg32 first = stream_for(1, 0, 0, 0);
  CHECK(first.next_bits() == 0x160b48d0u);
  CHECK(first.next_bits() == 0x376543d8u);
  Pcg32 last = stream_for(7, 899, 719, 1023);
  CHECK(last.next_bits() == 0xa53f579eu);
  CHECK(last.next_bits() == 0xe0d844ceu);
}

TEST_CASE("streams: pixels may be visited in any order") {
  const auto draws = [](int pixel) {
    Pcg32 random = stream_for(3, pixel % 40, pixel / 40, 2);
    return std::array{random.next_bits(), random.next_bits(), random.next_bits()};
  };
  std::vector<std::array<std::uint32_t, 3>> forwards(1200), shuffled(1200);
  for (int pixel = 0; pixel < 1200; ++pixel)
    forwards[static_cast<std::size_t>(pixel)] = draws(pixel);
  for (int i = 0; i < 1200; ++i) {
    const int pixel = i * 7 % 1200;  // 7 and 1200 have no common factor: every pixel once
    shuffled[static_cast<std::size_t>(pixel)] = draws(pixel);
  }
  CHECK(forwards == shuffled);
}

TEST_CASE("streams: no two of a million share their first four draws") {
  std::vector<std::array<std::uint32_t, 4>> starts;
  for (int y = 0; y < 250; ++y)
    for (int x = 0; x < 250; ++x)
      for (int sample = 0; sample < 16; ++sample) {
        Pcg32 random = stream_for(1, x, y, sample);
        std::array<std::uint32_t, 4>& start = starts.emplace_back();
        for (std::uint32_t& draw : start)
          draw = random.next_bits();
      }
  REQUIRE(starts.size() == 1'000'000);
  std::sort(starts.begin(), starts.end());
  CHECK(std::adjacent_find(starts.begin(), starts.end()) == starts.end());
  // First draws alone do meet, as birthdays do: n (n - 1) / 2 pairs, each with probability 2^-32,
  // 116.4 expected with a standard deviation of the root of it.
  int equal = 0;
  for (std::size_t i = 1; i < starts.size(); ++i)
    equal += starts[i][0] == starts[i - 1][0];
  const double expected = 0.5e6 * (1e6 - 1) * 0x1p-32;
  CHECK(z_test(equal, std::sqrt(expected), expected).agrees());
}

TEST_CASE("streams: pixels, samples and seeds next to each other are not correlated") {
  constexpr int count = 250'000;
  const double limit = 5 / std::sqrt(count);
  std::vector<double> here, right, below, next_sample, next_seed, next_draw;
  for (int i = 0; i < count; ++i) {
    const int x = i % 500;
    const int y = i / 500;
    Pcg32 random = stream_for(1, x, y, 0);
    here.push_back(random.next_float());
    next_draw.push_back(random.next_float());
    right.push_back(stream_for(1, x + 1, y, 0).next_float());
    below.push_back(stream_for(1, x, y + 1, 0).next_float());
    next_sample.push_back(stream_for(1, x, y, 1).next_float());
    next_seed.push_back(stream_for(2, x, y, 0).next_float());
  }
  for (const auto& there : {right, below, next_sample, next_seed, next_draw})
    CHECK(std::abs(correlation(here, there)) < limit);
}

TEST_CASE("streams: first draws over pixels are uniform, and so are pairs of first two draws") {
  constexpr int side = 32;
  std::vector<double> counts(side * side);
  std::vector<double> firsts;
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 400; ++x) {
      const vec2 u = stream_for(4, x, y, 0).next_vec2();
      firsts.push_back(u.x);
      const ivec2 cell(u * static_cast<float>(side));
      ++counts[static_cast<std::size_t>(cell.y * side + cell.x)];
    }
  CHECK(kolmogorov_smirnov(firsts, [](double x) { return x; }).p_value > 1e-6);
  const std::vector<double> expected(counts.size(), 160'000.0 / (side * side));
  CHECK(chi_square(counts, expected).p_value > 1e-6);
}

TEST_CASE("streams: means of 16 samples are not correlated from pixel to pixel") {
  constexpr int side = 200;
  CHECK(largest_neighbour_correlation(stream_for, side, 16) < 6.0 / side);
}

TEST_CASE("streams, mistakes: shared and neighbouring seeds are found out") {
  constexpr int side = 100;
  CHECK(largest_neighbour_correlation(mistakes::same_stream, side, 1) > 0.1);
  CHECK(largest_neighbour_correlation(mistakes::diagonal_stream, side, 1) > 0.9);
  // Neighbouring seeds pass with one sample. With 16, two pixels in a row share most of theirs.
  CHECK(largest_neighbour_correlation(mistakes::neighbour_stream, side, 1) < 6.0 / side);
  CHECK(largest_neighbour_correlation(mistakes::neighbour_stream, side, 16) > 0.5);
}
