#include "api.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::Pcg32;
using exercise::stream_for;
using Four = std::array<std::uint32_t, 4>;

// Which stream.
struct Key {
  std::uint64_t seed;
  int x, y, sample;
};

std::string shown(const Key& key) {
  std::ostringstream text;
  text << "seed " << key.seed << ", pixel (" << key.x << ", " << key.y << "), sample "
       << key.sample;
  return text.str();
}

Four next_four(Pcg32& random) {
  Four four{};
  for (std::uint32_t& draw : four)
    draw = random.next_bits();
  return four;
}

Four start_of(const Key& key) {
  Pcg32 random = stream_for(key.seed, key.x, key.y, key.sample);
  return next_four(random);
}

bool are_equal(const Key& a, const Key& b) {
  return start_of(a) == start_of(b);
}

std::string same_numbers(const Key& a, const Key& b) {
  std::ostringstream text;
  text << shown(a) << " and " << shown(b) << " both begin with " << start_of(a)[0] << ' '
       << start_of(a)[1] << ' ' << start_of(a)[2] << ' ' << start_of(a)[3] << '.';
  return text.str();
}

// The width of a picture in which pixel (width, 0) has the numbers of pixel (0, 1), and x counts.
std::optional<int> colliding_width(std::uint64_t seed) {
  const Four below = start_of({seed, 0, 1, 0});
  for (int width = 2; width < 65536; ++width)
    if (start_of({seed, width, 0, 0}) == below)
      return below == start_of({seed, 0, 0, 0}) ? std::nullopt : std::optional(width);
  return std::nullopt;
}

// A million keys that are near each other: 4 seeds, 8 samples, 64 x 128 pixels in four places.
constexpr int million = 1 << 20;

Key near_key(std::uint64_t seed, int i) {
  const int place = i >> 5 & 3;
  const int x = (i >> 7 & 63) + (place & 1) * 1900;
  const int y = (i >> 13 & 127) + (place & 2) * 500;
  return {seed + (i & 3), x, y, i >> 2 & 7};
}

// Four numbers in one. Of a million, two agree by chance once in 3e7 runs.
std::uint64_t digest(const Four& four) {
  const std::uint64_t low = std::uint64_t{four[0]} << 32 | four[1];
  const std::uint64_t high = std::uint64_t{four[2]} << 32 | four[3];
  return low ^ high * 0x9e3779b97f4a7c15u;
}

// Two of the keys key_of(0), key_of(1), ... whose streams share their first four numbers.
std::optional<std::pair<Key, Key>> two_that_are_equal(const auto& key_of, int count) {
  std::vector<std::uint64_t> digests;
  for (int i = 0; i < count; ++i)
    digests.push_back(digest(start_of(key_of(i))));
  std::sort(digests.begin(), digests.end());
  const auto twice = std::adjacent_find(digests.begin(), digests.end());
  if (twice == digests.end()) return std::nullopt;

  std::vector<Key> found;
  for (int i = 0; i < count; ++i)
    if (digest(start_of(key_of(i))) == *twice) found.push_back(key_of(i));
  if (found.size() < 2 || !are_equal(found[0], found[1])) return std::nullopt;
  return std::pair{found[0], found[1]};
}

// How many numbers later, up to 1,000, one stream begins as another.
std::optional<int> overlap(const Key& a, const Key& b) {
  Pcg32 random = stream_for(a.seed, a.x, a.y, a.sample);
  Four window = next_four(random);
  const Four other = start_of(b);
  for (int later = 0; later < 1000; ++later) {
    if (window == other) return later;
    std::rotate(window.begin(), window.begin() + 1, window.end());
    window[3] = random.next_bits();
  }
  return std::nullopt;
}

constexpr int noise_side = 128;

// A square of numbers, one for each pixel.
struct Noise {
  int side;
  std::vector<double> values;
  [[nodiscard]] double at(int x, int y) const {
    return values[static_cast<std::size_t>(y * side + x)];
  }
};

// A picture whose pixels are means of some samples' first numbers, scaled to mean 0 and variance 1.
Noise noise(std::uint64_t seed, int samples, int first_sample = 0) {
  Noise picture{noise_side, {}};
  lt::RunningMean all;
  for (int y = 0; y < picture.side; ++y)
    for (int x = 0; x < picture.side; ++x) {
      double sum = 0.0;
      for (int sample = 0; sample < samples; ++sample)
        sum += stream_for(seed, x, y, first_sample + sample).next_float();
      picture.values.push_back(sum);
      all.add(sum);
    }
  for (double& value : picture.values)
    value = (value - all.mean()) / std::sqrt(all.variance() + 1e-12);
  return picture;
}

// Independent pixels have correlations around 0; one in 5e8 is larger than six standard errors.
struct Correlation {
  int dx = 0, dy = 0;
  double value = 0.0;
  double limit = 1.0;  // 6 / sqrt(pairs of pixels)
  [[nodiscard]] double excess() const { return std::abs(value) / limit; }
};

// Pixels of one picture with those of another, dx to the right and dy below.
Correlation correlation(const Noise& here, const Noise& there, int dx, int dy) {
  double sum = 0.0;
  int pairs = 0;
  for (int y = 0; y + dy < here.side; ++y)
    for (int x = std::max(0, -dx); x + std::max(0, dx) < here.side; ++x, ++pairs)
      sum += here.at(x, y) * there.at(x + dx, y + dy);
  return {dx, dy, sum / pairs, 6.0 / std::sqrt(pairs)};
}

// The worst of all pixels up to four away, two rows down.
Correlation worst_neighbour(const Noise& picture) {
  Correlation worst;
  for (int dy = 0; dy <= 2; ++dy)
    for (int dx = dy == 0 ? 1 : -4; dx <= 4; ++dx) {
      const Correlation found = correlation(picture, picture, dx, dy);
      if (found.excess() > worst.excess()) worst = found;
    }
  return worst;
}

}  // namespace

TEST_CASE("a stream depends on seed, pixel and sample, and on nothing else") {
  const Key key{7, 3, 5, 2};
  const Four first = start_of(key);
  for (const Key& between : {Key{7, 4, 4, 2}, Key{1, 0, 0, 0}, key}) {
    (void)start_of(between);
    const Four again = start_of(key);
    std::ostringstream seen;
    seen << shown(key) << " began with " << first[0] << ' ' << first[1]
         << " at the first call and with " << again[0] << ' ' << again[1] << " at a later one.";
    lt::diagnose(first == again, "one-global-generator", seen.str());
  }
}

TEST_CASE("each of the four arguments counts") {
  for (const auto seed : lt::seeds()) {
    const Key key{seed, 3, 5, 2};
    const Key sample{seed, 3, 5, 3};
    const Key other_seed{seed + 1, 3, 5, 2};
    const Key swapped{seed, 5, 3, 2};
    const Key diagonal{seed, 4, 4, 2};
    const Key right{seed, 4, 5, 2};
    const Key below{seed, 3, 6, 2};
    const Key shifted{seed + 1, 3, 5, 1};
    lt::diagnose(!are_equal(key, sample), "sample-forgotten", same_numbers(key, sample));
    lt::diagnose(!are_equal(key, other_seed), "seed-forgotten", same_numbers(key, other_seed));
    lt::diagnose(!(are_equal(key, right) && are_equal(key, below)), "pixel-forgotten",
                 same_numbers(key, right));
    if (are_equal(key, right)) UNSCOPED_INFO(same_numbers(key, right));
    REQUIRE(!are_equal(key, right));
    if (are_equal(key, below)) UNSCOPED_INFO(same_numbers(key, below));
    REQUIRE(!are_equal(key, below));
    lt::diagnose(!are_equal(key, diagonal), "seed-x-plus-y", same_numbers(key, diagonal));
    lt::diagnose(!are_equal(key, swapped), "x-and-y-exchanged", same_numbers(key, swapped));
    lt::diagnose(!are_equal(key, shifted), "seed-plus-sample", same_numbers(key, shifted));
  }
}

TEST_CASE("no two streams have the same numbers") {
  for (const auto seed : lt::seeds()) {
    const bool is_first = seed == lt::seeds().front();  // the long way once
    if (is_first) {
      const auto width = colliding_width(seed);
      lt::diagnose(!width, "fixed-width",
                   same_numbers({seed, width.value_or(0), 0, 0}, {seed, 0, 1, 0}));
    }
    const auto equal = two_that_are_equal([seed](int i) { return near_key(seed, i); },
                                          is_first ? million : million / 256);
    if (equal) UNSCOPED_INFO(same_numbers(equal->first, equal->second));
    REQUIRE(!equal);
    for (int i = 0; i < 8; ++i)
      for (const auto& [a, b] : {std::pair(Key{seed, 3, 5, i}, Key{seed, 3, 5, i + 1}),
                                 std::pair(Key{seed, i, 5, 2}, Key{seed, i + 1, 5, 2})}) {
        const auto later = overlap(a, b) ? overlap(a, b) : overlap(b, a);
        std::ostringstream seen;
        seen << shown(a) << " and " << shown(b) << " are one stream, " << later.value_or(0)
             << (later == 1 ? " number" : " numbers") << " apart.";
        lt::diagnose(!later, "streams-overlap", seen.str());
      }
  }
}

TEST_CASE("pixels are not alike, nor are samples and seeds") {
  double largest = 0.0;
  for (const auto seed : lt::seeds()) {
    // Seeds in a row may look well with one sample and share most of their sum with 16.
    for (const int samples : {16, 1}) {
      const Correlation worst = worst_neighbour(noise(seed, samples));
      largest = std::max(largest, std::abs(worst.value));
      if (worst.excess() < 1.0) continue;
      std::ostringstream seen;
      seen.precision(2);
      seen << "pixels of " << samples << (samples == 1 ? " sample" : " samples") << " and those "
           << std::abs(worst.dx) << (worst.dx < 0 ? " to the left and " : " to the right and ")
           << worst.dy << " below have a correlation of " << worst.value
           << "; chance alone stays within " << worst.limit << '.';
      const auto equal = two_that_are_equal(
          [seed](int i) {
            return Key{seed, i % 80, i / 80 % 80, i / 6400};
          },
          4 * 6400);
      lt::diagnose(equal.has_value(), "neighbouring-seeds", seen.str());
      UNSCOPED_INFO(seen.str());
      REQUIRE(worst.excess() < 1.0);
    }
    const Noise here = noise(seed, 1);
    const Correlation next_sample = correlation(here, noise(seed, 1, 1), 0, 0);
    INFO("a pixel and its next sample have a correlation of " << next_sample.value << '.');
    REQUIRE(next_sample.excess() < 1.0);
    const Correlation next_seed = correlation(here, noise(seed + 1, 1), 0, 0);
    INFO("a pixel and that of the next seed have a correlation of " << next_seed.value << '.');
    REQUIRE(next_seed.excess() < 1.0);
  }
  std::ostringstream text;
  text << "a million streams begin with different numbers, and neighbouring pixels correlate by at "
          "most "
       << std::round(largest * 1000) / 1000;
  lt::measured(text.str());
}

TEST_CASE("first numbers are uniform") {
  for (const auto seed : lt::seeds()) {
    std::vector<double> firsts;
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 100; ++x)
        firsts.push_back(stream_for(seed, x, y, 0).next_float());
    const auto found = lt::kolmogorov_smirnov(firsts, [](double x) { return x; });
    INFO("the distribution is up to " << found.distance << " from uniform.");
    REQUIRE(found.p_value > 1e-6);
  }
}
