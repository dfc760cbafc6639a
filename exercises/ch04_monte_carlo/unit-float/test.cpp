#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::unit_float;

std::string hex(std::uint32_t bits) {
  std::ostringstream text;
  text << "0x" << std::hex << std::setw(8) << std::setfill('0') << bits;
  return text.str();
}

std::string shown(float x) {
  std::ostringstream text;
  text << std::setprecision(9) << x;  // as many digits as tell every float from its neighbours
  return text.str();
}

std::string gave(std::uint32_t bits, const std::string& expected) {
  return hex(bits) + " gave " + shown(unit_float(bits)) + " and should give " + expected + ".";
}

bool is_in_range(float x) {
  return x >= 0.0f && x < 1.0f;  // false for NaN
}

// Where rounding, signs and shifts show.
std::vector<std::uint32_t> awkward_bits() {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < 1024; ++i) {
    all.push_back(i);
    all.push_back(0x80000000u - 512 + i);
    all.push_back(0xffffffffu - i);
  }
  for (int shift = 0; shift < 32; ++shift)
    for (const std::uint32_t pattern : {1u, 0xffu, 0xffffffffu, 0xffffff00u})
      all.push_back(pattern << shift);
  return all;
}

// Of the 1,024 largest numbers, how many become 1.
int ones_at_the_top() {
  int count = 0;
  for (std::uint32_t below = 0; below < 1024; ++below)
    count += unit_float(0xffffffffu - below) == 1.0f;
  return count;
}

constexpr int draws = 1 << 17;

std::vector<float> drawn(std::uint64_t seed) {
  lt::TestRandom random(seed);
  std::vector<float> all(draws);
  for (float& x : all)
    x = unit_float(static_cast<std::uint32_t>(random.next_bits() >> 32));
  return all;
}

struct Repeats {
  int different;   // how many different values there are
  int most;        // how often the most frequent one comes
  float frequent;  // which one that is
};

Repeats repeats(std::vector<float> values) {
  std::sort(values.begin(), values.end());
  Repeats found{0, 0, 0};
  for (std::size_t start = 0, end = 0; start < values.size(); start = end) {
    while (end < values.size() && values[end] == values[start])
      ++end;
    ++found.different;
    if (static_cast<int>(end - start) > found.most)
      found = {found.different, static_cast<int>(end - start), values[start]};
  }
  return found;
}

}  // namespace

TEST_CASE("the result is never 1, never more, never negative") {
  // Plain ones first: a sign, a division that came too early, a 1 too much.
  const float quarter = unit_float(0x40000000u);
  const float three_quarters = unit_float(0xc0000000u);
  lt::diagnose(!(three_quarters < 0.0f), "signed-bits", gave(0xc0000000u, "0.75"));
  lt::diagnose(!(quarter == 0.0f && three_quarters == 0.0f && unit_float(0x12345678u) == 0.0f),
               "integer-division", gave(0xc0000000u, "0.75"));
  lt::diagnose(!(quarter >= 1.0f && quarter < 2.0f && three_quarters >= 1.0f &&
                 three_quarters < 2.0f && unit_float(0) >= 1.0f),
               "one-not-subtracted", gave(0xc0000000u, "0.75"));

  // Below 1, floats are 2^-24 apart, and 2^32 - 2^7 is halfway from the last of them to 2^32: that
  // number and all above are rounded up, 0xffffff00 is not. 0x80000080 is halfway as well, between
  // 0.5 and the next float. A tie goes to the even one, 0.5, unless something has made the number
  // larger first: a division by 2^32 - 1 in double has. So has a half added to all, but then 0
  // does not stay 0.
  const int ones = ones_at_the_top();
  const bool divides_by_largest =
      unit_float(0) == 0.0f &&
      (unit_float(0xffffff00u) == 1.0f || unit_float(0x80000080u) == 0.5f + 0x1p-24f);
  std::ostringstream seen;
  seen << hex(0xffffffffu) << " gave " << shown(unit_float(0xffffffffu))
       << " and should stay below it";
  if (ones > 1) seen << "; of the 1,024 largest numbers, " << ones << " become 1";
  seen << ".";
  lt::diagnose(!(ones > 0 && divides_by_largest), "divide-by-2-32-minus-1", seen.str());
  lt::diagnose(ones == 0, "float-rounds-to-one", seen.str());

  for (const std::uint32_t bits : awkward_bits()) {
    if (!is_in_range(unit_float(bits))) UNSCOPED_INFO(gave(bits, "a number in [0, 1)"));
    REQUIRE(is_in_range(unit_float(bits)));
  }
}

TEST_CASE("there are millions of different results") {
  for (const auto seed : lt::seeds()) {
    // n draws from N values meet n^2 / 2N times: 1,024 times if N is 2^23, give or take 32. Six
    // standard deviations allow for 1,216, and half as many values meet twice as often.
    const Repeats found = repeats(drawn(seed));
    std::ostringstream seen;
    seen << draws << " draws gave " << found.different << " different results; "
         << "of 2^24 equally likely ones about 130,560 come up.";
    const bool is_constant = found.different == 1;  // some other mistake
    lt::diagnose(is_constant || found.different > draws / 2, "too-coarse", seen.str());
    if (found.different < draws - 1216) UNSCOPED_INFO(seen.str());
    REQUIRE(found.different >= draws - 1216);
    // One value four times is rare: draws^4 / 24 / 2^69 = 0.02 times in a run. Nine is a fault.
    if (found.most > 8)
      UNSCOPED_INFO(shown(found.frequent) << " came " << found.most << " times in " << draws
                                          << " draws, and should hardly come twice.");
    REQUIRE(found.most <= 8);
  }
}

TEST_CASE("all results are equally likely") {
  for (const auto seed : lt::seeds()) {
    std::vector<double> counts(256);
    const std::vector<float> all = drawn(seed);
    REQUIRE(std::all_of(all.begin(), all.end(), is_in_range));
    for (const float x : all)
      ++counts[static_cast<std::size_t>(x * 256.0f)];
    const std::vector<double> expected(counts.size(), draws / 256.0);  // 512
    const lt::ChiSquare found = lt::chi_square(counts, expected);
    const auto [fewest, most] = std::minmax_element(counts.begin(), counts.end());
    std::ostringstream seen;
    seen << "256 equal parts of [0, 1) should hold about 512 of " << draws << " results each; part "
         << fewest - counts.begin() << " holds " << *fewest << " and part " << most - counts.begin()
         << " holds " << *most << '.';
    if (found.p_value <= 1e-6) UNSCOPED_INFO(seen.str());
    REQUIRE(found.p_value > 1e-6);
  }
  float largest = 0.0f;
  for (const std::uint32_t bits : awkward_bits())
    largest = std::max(largest, unit_float(bits));
  lt::measured("the largest result is " + shown(largest) +
               "; divided as a float, 128 numbers would have become 1");
}
