#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using namespace exercise;
using glm::dvec2;
using Numbers = std::vector<double>;

constexpr double largest_u = 1 - 0x1p-53;

// Six digits; numbers that come nearer to 1 in full.
std::string text_of(double x) {
  return lt::text_of(x, std::abs(x - 1) < 1e-6 ? 17 : 6);
}

std::string text_of(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : ", ") + text_of(number);
  return "{" + text + "}";
}

bool are_near(const Numbers& a, const Numbers& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return std::abs(x - y) < 1e-6; });
}

// The tests' own sums, exact if the weights are whole numbers whose sum is a power of 2.
Numbers exact_cdf(const Numbers& weights) {
  Numbers cdf(weights.size() + 1);
  std::partial_sum(weights.begin(), weights.end(), cdf.begin() + 1);
  for (double& share : cdf)
    share /= cdf.back();  // which is itself the last
  return cdf;
}

const Numbers four{1, 3, 0, 4};
const Numbers gaps = exact_cdf({0, 0, 1, 3, 0, 2, 0, 0, 0, 10, 0});  // sixteenths
const Numbers between{0.03, 0.1, 0.2, 0.3, 0.4, 0.99, largest_u};

// A third of them 0, but never all.
Numbers random_weights(lt::TestRandom& random, int n) {
  Numbers weights;
  for (int i = 0; i < n; ++i)
    weights.push_back(random.uniform() < 0.35 ? 0.0 : random.uniform());
  weights[random.next_bits() % weights.size()] = 0.5;
  return weights;
}

// The first u below 1 whose bin is not the right one, or not `shift` bins beyond it, in words.
std::string wrong_bin(const Numbers& cdf, const Numbers& us, int shift = 0) {
  for (const double u : us) {
    int right = 0;
    while (u < 1 && cdf[right + 1] <= u)
      ++right;  // it ends at the first edge above u
    if (const int bin = u < 1 ? find_bin(cdf, u) : shift; bin != right + shift)
      return "find_bin(" + text_of(cdf) + ", " + text_of(u) + ") gave " + text_of(bin) +
             " and should give " + text_of(right) + ".";
  }
  return "";
}

// What places and planes stand on: without it they would run into walls.
bool sums_and_bins_are_right() {
  return cumulative(four) == exact_cdf(four) && cumulative(Numbers(10, 1)).back() == 1 &&
         wrong_bin(gaps, between).empty() && wrong_bin(gaps, gaps).empty();
}

// A sample on an edge whose density is 0, in words. Looked for in tables of 2 to 200 bins that are
// empty at one end, where the other bins begin.
std::string landing_in_empty_bin() {
  for (int bins = 2; bins <= 200; ++bins)
    for (const bool is_first : {true, false}) {
      Numbers weights(bins, 1.0);
      (is_first ? weights.front() : weights.back()) = 0;
      const Numbers cdf = exact_cdf(weights);
      for (const double u : {0.0, largest_u})
        if (const double x = sample(cdf, u);
            !(pdf(cdf, x) > 0) && are_near({std::round(x * bins)}, {x * bins}))
          return "of " + text_of(bins) + " bins the " + (is_first ? "first" : "last") +
                 " is empty and the others are alike; u = " + text_of(u) +
                 " gave x = " + text_of(x) + ", where pdf() is 0.";
    }
  return "";
}

// Rows {5, 0} and {1, 2}, and what they become by mistake.
const Grid square{2, {5, 0, 1, 2}};
const Grid rows_alike{2, {4, 0, 4.0 / 3, 8.0 / 3}};   // each row half of 8
const Grid independent{2, {3.75, 1.25, 2.25, 0.75}};  // rows 5, 3 times columns 6, 2
const Grid exchanged{2, {5, 1, 0, 2}};
const Grid holes{3, {0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0}};  // rows 0, 2, 4 are empty

// How many of 10,000 random places fall into each quarter of a cell; nothing if one is none.
Numbers counted(const Grid& grid, std::uint64_t seed) {
  Numbers quarters(4 * grid.weights.size());
  const int columns = 2 * grid.columns;
  const int rows = static_cast<int>(quarters.size()) / columns;
  lt::TestRandom random(seed);
  for (int i = 0; i < 10'000; ++i) {
    const double u = random.uniform();
    const dvec2 p = sample(grid, {u, random.uniform()});
    if (!(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1)) return {};
    ++quarters[static_cast<int>(p.y * rows) * columns + static_cast<int>(p.x * columns)];
  }
  return quarters;
}

// What is wrong with that in a grid (chi-square); nothing if it is right.
std::string misfit(const Numbers& counts, const Grid& grid) {
  if (counts.empty()) return "a place lies outside of the square.";
  const int columns = 2 * grid.columns;
  const double sum = std::accumulate(grid.weights.begin(), grid.weights.end(), 0.0);
  Numbers right;
  const auto off = [&](int i) { return std::pow(counts[i] - right[i], 2) / (right[i] + 0.01); };
  int worst = 0;
  for (int i = 0; i < static_cast<int>(counts.size()); ++i) {
    right.push_back(2500 / sum * grid.weights[i / columns / 2 * grid.columns + i % columns / 2]);
    if (off(i) > off(worst)) worst = i;
  }
  if (lt::chi_square(counts, right).p_value > 1e-6) return "";
  return "with weights " + text_of(grid.weights) + ", " + text_of(grid.columns) +
         " in a row, column " + text_of(worst % columns) + " and row " + text_of(worst / columns) +
         " of the quarter cells hold " + text_of(counts[worst]) +
         " of 10,000 places and should hold about " + text_of(right[worst]) + ".";
}

}  // namespace

TEST_CASE("cumulative goes from 0 to exactly 1") {
  const Numbers cdf = cumulative(four);
  const std::string gave =
      "cumulative({1, 3, 0, 4}) gave " + text_of(cdf) + " and should give {0, 0.125, 0.5, 0.5, 1}.";
  lt::diagnose(cdf != Numbers({0, 1, 4, 4, 8}), "sums-not-shares", gave);
  if (cdf != exact_cdf(four)) FAIL(gave);
  for (const int bins : {10, 49}) {
    Numbers weights(bins, 1);
    weights.push_back(0);
    const Numbers shares = cumulative(weights);
    const double sum = shares.at(bins);
    lt::diagnose(sum == 1 || !are_near({sum}, {1}), "last-bin-overflow",
                 "shares of " + text_of(bins) + " equal bins add up to " + text_of(sum) + ".");
    REQUIRE((sum == 1 && shares.back() == 1));
  }
}

TEST_CASE("find_bin gives the bin that u lies in, and never an empty one") {
  const std::string wrong = wrong_bin(gaps, between);
  lt::diagnose(wrong.empty() || !wrong_bin(gaps, between, 1).empty(), "one-bin-too-far", wrong);
  if (!wrong.empty()) FAIL(wrong);
  lt::diagnose(wrong_bin(gaps, gaps).empty(), "edge-picks-empty-bin", wrong_bin(gaps, gaps));
}

TEST_CASE("the density is a bin's share over its width, and 0 outside of [0, 1)") {
  const Numbers cdf = exact_cdf(four);
  const Numbers found{pdf(cdf, 0.2), pdf(cdf, 0.3), pdf(cdf, 0.7), pdf(cdf, 0.8)};
  const std::string gave = "in the bins of {1, 3, 0, 4} pdf() gave " + text_of(found) +
                           " and should give {0.5, 1.5, 0, 2}.";
  lt::diagnose(!are_near(found, {0.125, 0.375, 0, 0.5}), "share-not-density", gave);
  if (!are_near(found, {0.5, 1.5, 0, 2})) FAIL(gave);
  for (const double x : {-0.1, -1e-9, 1.0, 1.1, 7.0})
    if (pdf(cdf, x) != 0) FAIL("pdf() at x = " << x << " gave " << pdf(cdf, x) << ", not 0.");
}

TEST_CASE("a sample lies where the distribution reaches u, and never in an empty bin") {
  const Numbers cdf = exact_cdf(four);
  REQUIRE((sums_and_bins_are_right() && are_near({pdf(cdf, 0.2), pdf(cdf, 0.7)}, {0.5, 0})));
  // u = 5/16 is the middle of bin 1, x from 1/4 to 1/2; u = 5/8 a quarter of bin 3, from 3/4 to 1.
  const Numbers found{sample(cdf, 0.3125), sample(cdf, 0.625), sample(cdf, 0.875)};
  const std::string gave = "for u = 0.3125, 0.625, 0.875 sample({0, 0.125, 0.5, 0.5, 1}, u) gave " +
                           text_of(found) + " and should give {0.375, 0.8125, 0.9375}.";
  lt::diagnose(!are_near({found[1]}, {found[2]}), "no-place-in-bin", gave);
  lt::diagnose(!are_near(found, {1.3125 / 4, 3.625 / 4, 3.875 / 4}), "u-not-stretched", gave);
  if (!are_near(found, {0.375, 0.8125, 0.9375})) FAIL(gave);
  lt::diagnose(landing_in_empty_bin().empty(), "rounds-into-empty-bin", landing_in_empty_bin());
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    const Numbers weights = random_weights(random, 20);
    const Numbers table = exact_cdf(weights);
    const Numbers cdf_20 = cumulative(weights);
    if (!are_near(cdf_20, table) || cdf_20.back() != 1)
      FAIL("cumulative() gave " << text_of(cdf_20) << " for " << text_of(weights) << '.');
    for (int i = 0; i < 200; ++i) {
      const double u = i <= 20 ? std::min(table[i], largest_u) : random.uniform();
      if (const std::string wrong = wrong_bin(table, {u}); !wrong.empty()) FAIL(wrong);
      // The distribution, read forwards, leads back to u.
      const double x = sample(table, u);
      const int bin = std::clamp(static_cast<int>(x * 20), 0, 19);
      const double at_x = std::lerp(table[bin], table[bin + 1], x * 20 - bin);
      if (!(x >= 0 && x < 1 && pdf(table, x) > 0 && are_near({at_x}, {u})))
        FAIL("u = " << u << " gave x = " << text_of(x) << ", where the density is " << pdf(table, x)
                    << " and the distribution " << at_x << ": " << text_of(table) << '.');
    }
  }
}

TEST_CASE("in the plane, a cell is as likely as its weight says, and so is all of it") {
  REQUIRE(sums_and_bins_are_right());
  const Numbers counts = counted(square, 1);
  const std::string wrong = misfit(counts, square);
  lt::diagnose(!misfit(counts, rows_alike).empty(), "rows-equally-likely", wrong);
  lt::diagnose(!misfit(counts, independent).empty(), "row-ignored-for-column", wrong);
  lt::diagnose(!misfit(counts, exchanged).empty(), "x-and-y-exchanged", wrong);
  if (!wrong.empty()) FAIL(wrong);
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (const Grid& grid : {holes, {2, random_weights(random, 14)}})
      if (const std::string bad = misfit(counted(grid, seed), grid); !bad.empty()) FAIL(bad);
  }
}

TEST_CASE("in the plane, the density is that of the row times that within it") {
  REQUIRE((sums_and_bins_are_right() && misfit(counted(square, 1), square).empty()));
  const Numbers found{pdf(square, {0.2, 0.3}), pdf(square, {0.7, 0.3}), pdf(square, {0.2, 0.8}),
                      pdf(square, {0.7, 0.8})};
  const std::string gave = "in the cells of the rows {5, 0} and {1, 2} pdf() gave " +
                           text_of(found) + " and should give {2.5, 0, 0.5, 1}.";
  lt::diagnose(!are_near(found, {2, 0, 2.0 / 3, 4.0 / 3}), "row-density-forgotten", gave);
  if (!are_near(found, {2.5, 0, 0.5, 1})) FAIL(gave);
  lt::diagnose(!std::isnan(pdf(holes, {0.5, 0.1})), "empty-row-is-nan",
               "pdf() in a row without weight gave nan and should give 0.");
  for (int i = 0; i < 15; ++i) {
    INFO("in column " << i % 3 << " and row " << i / 3 << " of 3 x 5");
    REQUIRE(pdf(holes, {(i % 3 + 0.5) / 3, (i / 3 + 0.5) / 5}) ==
            lt::close_to(holes.weights[i] * 15 / 6));
  }
  for (const dvec2 p : {dvec2(-0.1, 0.3), dvec2(1, 0.3), dvec2(0.2, -0.1), dvec2(0.2, 1)})
    REQUIRE(pdf(square, p) == 0);
  // Edges of the rows {0, 2, 0, 4, 0}, of the columns {1, 0, 3} and of all cells in a row.
  for (const double v : {0.0, 1.0 / 3, 0.5, largest_u})
    for (const double u : {0.0, 0.25, 1.0 / 3, 0.5, largest_u}) {
      const dvec2 p = sample(holes, {u, v});
      INFO("u = " << text_of({u, v}) << " gave " << text_of({p.x, p.y}) << '.');
      REQUIRE(pdf(holes, p) > 0);
    }
  lt::measured("10,000 random places fell into 3 of 15 cells, and none into the 12 empty ones");
}
