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
  return shown(a) + " and " + shown(b) + " both begin with " + std::to_string(start_of(a)[0]) + ".";
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
  return {seed + (i & 3), (i >> 7 & 63) + (place & 1) * 1900, (i >> 13 & 127) + (place & 2) * 500,
          i >> 2 & 7};
}

// Four numbers in one. Of a million, two agree by chance once in 3e7 runs.
std::uint64_t digest(const Four& four) {
  return (std::uint64_t{four[0]} << 32 | four[1]) ^
         (std::uint64_t{four[2]} << 32 | four[3]) * 0x9e3779b97f4a7c15u;
}

// Two of the keys key_of(0), key_of(1), ... whose streams share their first four numbers.
std::optional<std::pair<Key, Key>> two_that_are_equal(const auto& key_of, int count) {
  std::vector<std::pair<std::uint64_t, int>> all;
  all.reserve(count);
  for (int i = 0; i < count; ++i)
    all.emplace_back(digest(start_of(key_of(i))), i);
  std::sort(all.begin(), all.end());
  const auto is_same = [](const auto& a, const auto& b) { return a.first == b.first; };
  const auto found = std::adjacent_find(all.begin(), all.end(), is_same);
  if (found == all.end()) return std::nullopt;
  return std::pair{key_of(found[0].second), key_of(found[1].second)};
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

constexpr int side = 128;
using Noise = std::vector<double>;  // of side x side pixels, row by row

// A picture whose pixels are means of some samples' first numbers, scaled to mean 0 and variance 1.
Noise noise(std::uint64_t seed, int samples, int first_sample = 0) {
  Noise picture;
  lt::RunningMean all;
  for (int i = 0; i < side * side; ++i) {
    double sum = 0.0;
    for (int sample = 0; sample < samples; ++sample)
      sum += stream_for(seed, i % side, i / side, first_sample + sample).next_float();
    picture.push_back(sum);
    all.add(sum);
  }
  for (double& value : picture)
    value = (value - all.mean()) / std::sqrt(all.variance() + 1e-12);
  return picture;
}

// Independent pixels have correlations around 0; one in 5e8 is larger than six standard errors.
struct Correlation {
  int dx = 0, dy = 0;
  double value = 0.0, limit = 1.0;  // 6 / sqrt(pairs of pixels)
  [[nodiscard]] double excess() const { return std::abs(value) / limit; }
};

// Pixels of one picture with those of another, dx to the right and dy below.
Correlation correlation(const Noise& here, const Noise& there, int dx, int dy) {
  double sum = 0.0;
  int pairs = 0;
  for (int y = 0; y + dy < side; ++y)
    for (int x = std::max(0, -dx); x + std::max(0, dx) < side; ++x, ++pairs)
      sum += here[y * side + x] * there[(y + dy) * side + x + dx];
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
    const Key right{seed, 4, 5, 2};
    const Key below{seed, 3, 6, 2};
    const auto must_differ = [&key](const Key& other, const char* tag) {
      lt::diagnose(!are_equal(key, other), tag, same_numbers(key, other));
    };
    must_differ({seed, 3, 5, 3}, "sample-forgotten");
    must_differ({seed + 1, 3, 5, 2}, "seed-forgotten");
    lt::diagnose(!(are_equal(key, right) && are_equal(key, below)), "pixel-forgotten",
                 same_numbers(key, right));
    for (const Key& neighbour : {right, below})
      if (are_equal(key, neighbour)) FAIL(same_numbers(key, neighbour));
    must_differ({seed, 4, 4, 2}, "seed-x-plus-y");
    must_differ({seed, 5, 3, 2}, "x-and-y-exchanged");
    must_differ({seed + 1, 3, 5, 1}, "seed-plus-sample");
  }
}

TEST_CASE("no two streams have the same numbers") {
  for (const auto seed : lt::seeds()) {
    const bool is_first = seed == lt::seeds().front();  // the long way once
    const auto width = is_first ? colliding_width(seed) : std::nullopt;
    lt::diagnose(!width, "fixed-width",
                 same_numbers({seed, width.value_or(0), 0, 0}, {seed, 0, 1, 0}));
    const auto equal = two_that_are_equal([seed](int i) { return near_key(seed, i); },
                                          is_first ? million : million / 256);
    if (equal) FAIL(same_numbers(equal->first, equal->second));
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
      const auto key_of = [seed](int i) { return Key{seed, i % 80, i / 80 % 80, i / 6400}; };
      const bool are_two_equal = two_that_are_equal(key_of, 4 * 6400).has_value();
      lt::diagnose(are_two_equal, "neighbouring-seeds", seen.str());
      FAIL(seen.str());
    }
    const Noise here = noise(seed, 1);
    for (const auto& [other_seed, sample] : {std::pair(seed, 1), std::pair(seed + 1, 0)}) {
      const Correlation found = correlation(here, noise(other_seed, 1, sample), 0, 0);
      INFO("pixels of seed " << seed << " and those of seed " << other_seed << ", sample " << sample
                             << ", have a correlation of " << found.value << '.');
      REQUIRE(found.excess() < 1.0);
    }
  }
  std::ostringstream text;
  text << "a million streams begin with different numbers; neighbours correlate by at most "
       << std::round(largest * 1000) / 1000;
  lt::measured(text.str());
}

TEST_CASE("first numbers are uniform") {
  for (const auto seed : lt::seeds()) {
    std::vector<double> firsts;
    for (int i = 0; i < 10'000; ++i)
      firsts.push_back(stream_for(seed, i % 100, i / 100, 0).next_float());
    const auto found = lt::kolmogorov_smirnov(firsts, [](double x) { return x; });
    INFO("the distribution is up to " << found.distance << " from uniform.");
    REQUIRE(found.p_value > 1e-6);
  }
}
