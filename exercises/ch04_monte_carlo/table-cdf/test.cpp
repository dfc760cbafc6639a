#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::cumulative;
using exercise::find_bin;
using exercise::Grid;
using exercise::pdf;
using exercise::sample;
using glm::dvec2;
using Numbers = std::vector<double>;

constexpr double largest_u = 1 - 0x1p-53;

std::string text_of(double x, int digits = 6) {
  std::ostringstream text;
  text.precision(digits);
  text << (std::isnan(x) ? std::abs(x) : x);
  return text.str();
}

std::string text_of(const Numbers& numbers, int digits = 6) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : ", ") + text_of(number, digits);
  return "{" + text + "}";
}

std::string text_of(dvec2 p) {
  return "(" + text_of(p.x) + ", " + text_of(p.y) + ")";
}

// u, even if it is a hair below 1.
std::string text_of_u(double u) {
  if (u == largest_u) return "1 - 2^-53";
  return u == 1 - 0x1p-24 ? "1 - 2^-24" : text_of(u);
}

bool is_near(double a, double b, double tolerance = 1e-9) {
  return std::abs(a - b) <= tolerance;  // false for NaN
}

// The tests' own sums, exact if the weights are whole numbers whose sum is a power of 2.
Numbers exact_cdf(const Numbers& weights) {
  Numbers cdf{0};
  for (const double weight : weights)
    cdf.push_back(cdf.back() + weight);
  const double total = cdf.back();
  for (double& share : cdf)
    share /= total;
  return cdf;
}

const Numbers four{1, 3, 0, 4};                             // edges 0, 1/8, 1/2, 1/2 and 1
const Numbers with_gaps{0, 0, 1, 3, 0, 2, 0, 0, 0, 10, 0};  // sixteenths

Numbers on_edges(const Numbers& cdf) {
  Numbers us;
  for (const double edge : cdf)
    if (edge < 1) us.push_back(edge);
  return us;
}

Numbers between_edges(const Numbers& cdf) {
  Numbers us{1 - 0x1p-24, largest_u};
  for (std::size_t i = 1; i < cdf.size(); ++i)
    if (cdf[i] > cdf[i - 1]) us.push_back((cdf[i] + cdf[i - 1]) / 2);
  return us;
}

// The bin from its definition.
int true_bin(const Numbers& cdf, double u) {
  int bin = 0;
  while (!(cdf[bin] <= u && u < cdf[bin + 1]))
    ++bin;
  return bin;
}

// The first u whose bin is wrong, and by how much.
std::optional<double> wrong_u(const Numbers& cdf, const Numbers& us, int shift = 0) {
  for (const double u : us)
    if (find_bin(cdf, u) != true_bin(cdf, u) + shift) return u;
  return std::nullopt;
}

std::string gave_bin(const Numbers& cdf, std::optional<double> u) {
  if (!u) return "";
  std::ostringstream text;
  text << "find_bin(" << text_of(cdf) << ", " << text_of_u(*u) << ") gave " << find_bin(cdf, *u)
       << " and should give " << true_bin(cdf, *u) << '.';
  return text.str();
}

bool finds_bins(const Numbers& cdf, const Numbers& us) {
  const auto u = wrong_u(cdf, us);
  if (u) UNSCOPED_INFO(gave_bin(cdf, u));
  return !u;
}

// What sample() and the plane stand on: without it they would run into walls.
bool cumulative_and_find_bin_are_right() {
  const Numbers cdf = exact_cdf(with_gaps);
  return cumulative(four) == exact_cdf(four) && cumulative(Numbers(10, 1.0)).back() == 1 &&
         finds_bins(cdf, between_edges(cdf)) && finds_bins(cdf, on_edges(cdf));
}

std::string gave_place(const Numbers& weights, double u, double expected) {
  const Numbers cdf = exact_cdf(weights);
  return "sample(" + text_of(cdf) + ", " + text_of_u(u) + ") gave " + text_of(sample(cdf, u)) +
         " and should give " + text_of(expected) + ".";
}

// The distribution of the table, for any x.
double true_cdf(const Numbers& cdf, double x) {
  const double bins = static_cast<double>(cdf.size() - 1);
  const auto bin = static_cast<std::size_t>(std::clamp(std::floor(x * bins), 0.0, bins - 1));
  return std::lerp(cdf[bin], cdf[bin + 1], x * bins - static_cast<double>(bin));
}

// Random weights, a third of them 0, one for certain not.
Numbers random_weights(lt::TestRandom& random, int n) {
  Numbers weights;
  for (int i = 0; i < n; ++i)
    weights.push_back(random.uniform() < 0.35 ? 0.0 : random.uniform());
  weights[random.next_bits() % weights.size()] = 0.5;
  return weights;
}

// A table and a u for which sample() gives a place on an edge, and pdf() is 0 there.
// Looked for in tables of 2 to 200 bins that are empty at one end, where the other bins begin.
struct Landing {
  int bins;
  bool is_first_empty;
  double u, x;
};

std::optional<Landing> landing_in_empty_bin() {
  for (int bins = 2; bins <= 200; ++bins)
    for (const bool is_first_empty : {true, false}) {
      Numbers weights(static_cast<std::size_t>(bins), 1.0);
      (is_first_empty ? weights.front() : weights.back()) = 0;
      const Numbers cdf = exact_cdf(weights);
      for (const double u : {0.0, largest_u}) {
        const double x = sample(cdf, u);
        const bool is_on_edge = is_near(x * bins, std::round(x * bins));
        if (is_on_edge && !(pdf(cdf, x) > 0)) return Landing{bins, is_first_empty, u, x};
      }
    }
  return std::nullopt;
}

std::string seen(const std::optional<Landing>& landing) {
  if (!landing) return "";
  return "of " + std::to_string(landing->bins) + " bins the " +
         (landing->is_first_empty ? "first" : "last") +
         " is empty and the others are alike; u = " + text_of_u(landing->u) +
         " gave x = " + text_of(landing->x, 17) + ", " +
         (landing->x >= 1 ? "beyond the last bin." : "where pdf() is 0.");
}

// No row is empty, no column, and the rows differ.
const Grid small{3, {4, 0, 2, 0, 1, 1}};
const Numbers small_rows_alike{8.0 / 3, 0, 4.0 / 3, 0, 2, 2};  // each row half of 8
const Numbers small_independent{3, 0.75, 2.25,
                                1, 0.25, 0.75};  // rows 6 and 2 times columns 4, 1, 3

dvec2 in_small(dvec2 u) {
  return sample(small, u);
}

// Empty rows at both ends and between, and empty cells in each row.
const Grid holes{3, {0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0}};

double sum(const Numbers& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

using Place = std::function<dvec2(dvec2 u)>;

// Counts of places in the cells of a grid, for 120 x 120 evenly spread u, scaled to sum to `total`.
Numbers cell_counts(const Place& place, int columns, int rows, double total) {
  Numbers counts(static_cast<std::size_t>(columns) * rows);
  for (int i = 0; i < 120 * 120; ++i) {
    const dvec2 p = place((dvec2(i % 120, i / 120) + 0.5) / 120.0);
    if (!(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1)) return {};
    counts[static_cast<int>(p.y * rows) * columns + static_cast<int>(p.x * columns)] +=
        total / 14400;
  }
  return counts;
}

// Each edge of a cell may take or leave one row of u: 120 of 14,400, 0.07 of a sum of 8.
bool are_like(const Numbers& counts, const Numbers& weights) {
  if (counts.size() != weights.size()) return false;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (!is_near(counts[i], weights[i], 0.15)) return false;
  return true;
}

// The density in the middle of each cell of `grid`, scaled to the sum of its weights.
Numbers cell_densities(const Grid& grid) {
  const int rows = static_cast<int>(grid.weights.size()) / grid.columns;
  const double scale = sum(grid.weights) / static_cast<double>(grid.weights.size());
  Numbers densities;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < grid.columns; ++x)
      densities.push_back(scale * pdf(grid, {(x + 0.5) / grid.columns, (y + 0.5) / rows}));
  return densities;
}

// Random places against the weights, each cell in four parts (chi-square).
bool is_right_at_random(const Grid& grid, std::uint64_t seed) {
  constexpr int n = 10'000;
  lt::TestRandom random(seed);
  const int columns = 2 * grid.columns;
  const int rows = 2 * static_cast<int>(grid.weights.size()) / grid.columns;
  Numbers counts(static_cast<std::size_t>(columns) * rows), expected;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform();
    const dvec2 p = sample(grid, {u, random.uniform()});
    ++counts.at(static_cast<int>(p.y * rows) * columns + static_cast<int>(p.x * columns));
  }
  for (int i = 0; i < columns * rows; ++i)
    expected.push_back(grid.weights[i / columns / 2 * grid.columns + i % columns / 2] * n / 4 /
                       sum(grid.weights));
  if (lt::chi_square(counts, expected).p_value > 1e-6) return true;
  std::size_t worst = 0;
  const auto off = [&](std::size_t i) { return std::abs(counts[i] - expected[i]); };
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (off(i) > off(worst)) worst = i;
  const dvec2 corner(static_cast<double>(worst % columns) / columns,
                     static_cast<double>(worst / columns) / rows);
  UNSCOPED_INFO("from " << text_of(corner) << " to "
                        << text_of(corner + dvec2(1.0 / columns, 1.0 / rows)) << " there are "
                        << counts[worst] << " of 10,000 places; it should be about "
                        << text_of(expected[worst]) << ". Weights of the grid, " << grid.columns
                        << " in a row: " << text_of(grid.weights) << '.');
  return false;
}

}  // namespace

TEST_CASE("cumulative goes from 0 to exactly 1") {
  const Numbers cdf = cumulative(four);
  const std::string gave =
      "cumulative({1, 3, 0, 4}) gave " + text_of(cdf) + " and should give {0, 0.125, 0.5, 0.5, 1}.";
  lt::diagnose(cdf != Numbers({0, 1, 4, 4, 8}), "sums-not-shares", gave);
  const bool is_right = cdf == exact_cdf(four);
  if (!is_right) UNSCOPED_INFO(gave);
  REQUIRE(is_right);
  Numbers ten_and_none(10, 1.0);
  ten_and_none.push_back(0);
  for (const Numbers& weights : {Numbers(10, 1.0), ten_and_none, Numbers(49, 1.0)}) {
    const Numbers shares = cumulative(weights);
    REQUIRE(shares.size() == weights.size() + 1);
    const std::size_t last = weights.back() > 0 ? weights.size() : weights.size() - 1;
    const bool is_rounded = is_near(shares[last], 1) && shares[last] != 1;
    lt::diagnose(!is_rounded, "last-bin-overflow",
                 "the shares of " + (weights.size() > 11 ? "49 equal bins" : text_of(weights)) +
                     " add up to " + text_of(shares[last], 17) + " instead of 1.");
    REQUIRE(shares.back() == 1);
  }
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    const Numbers weights = random_weights(random, 50);
    const Numbers shares = cumulative(weights);
    const Numbers expected = exact_cdf(weights);
    REQUIRE(shares.size() == expected.size());
    REQUIRE(shares.front() == 0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      REQUIRE(is_near(shares[i + 1], expected[i + 1]));
      if (weights[i] == 0) REQUIRE(shares[i + 1] == shares[i]);
    }
    REQUIRE(shares.back() == 1);
  }
}

TEST_CASE("find_bin gives the bin that u lies in, and never an empty one") {
  const Numbers cdf = exact_cdf(with_gaps);
  const Numbers between = between_edges(cdf);
  const auto wrong = wrong_u(cdf, between);
  lt::diagnose(!(wrong && !wrong_u(cdf, between, 1)), "one-bin-too-far", gave_bin(cdf, wrong));
  REQUIRE(finds_bins(cdf, between));
  lt::diagnose(!wrong_u(cdf, on_edges(cdf)), "edge-picks-empty-bin",
               gave_bin(cdf, wrong_u(cdf, on_edges(cdf))));
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    const Numbers table = exact_cdf(random_weights(random, 50));
    REQUIRE(finds_bins(table, between_edges(table)));
    REQUIRE(finds_bins(table, on_edges(table)));
  }
}

TEST_CASE("the density is a bin's share over its width") {
  const Numbers cdf = exact_cdf(four);
  Numbers found;
  for (const double x : {0.2, 0.3, 0.7, 0.8})
    found.push_back(pdf(cdf, x));
  const std::string gave = "in the bins of {1, 3, 0, 4} pdf() gave " + text_of(found) +
                           " and should give {0.5, 1.5, 0, 2}.";
  lt::diagnose(found != Numbers({0.125, 0.375, 0, 0.5}), "share-not-density", gave);
  const bool is_right = found == Numbers({0.5, 1.5, 0, 2});
  if (!is_right) UNSCOPED_INFO(gave);
  REQUIRE(is_right);
}

TEST_CASE("outside of [0, 1) the density is 0") {
  for (const double x : {-0.1, -1e-9, 1.0, 1.1, 7.0}) {
    INFO("at x = " << x);
    REQUIRE(pdf(exact_cdf(four), x) == 0);
  }
}

TEST_CASE("a sample lies where the distribution reaches u") {
  REQUIRE(cumulative_and_find_bin_are_right());
  const Numbers cdf = exact_cdf(four);
  // u = 5/16 is the middle of bin 1, x from 1/4 to 1/2; u = 5/8 a quarter of bin 3, from 3/4 to 1.
  const double middle = sample(cdf, 0.3125);
  const double quarter = sample(cdf, 0.625);
  const std::string gave = gave_place(four, 0.625, 0.8125);
  lt::diagnose(!is_near(quarter, sample(cdf, 0.875), 1e-6), "no-place-in-bin",
               gave_place(four, 0.625, 0.8125) + " u = 0.875 gave the same.");
  lt::diagnose(!(is_near(middle, 1.3125 / 4, 1e-6) && is_near(quarter, 3.625 / 4, 1e-6)),
               "u-not-stretched", gave);
  if (!is_near(middle, 0.375, 1e-6)) UNSCOPED_INFO(gave_place(four, 0.3125, 0.375));
  REQUIRE(is_near(middle, 0.375, 1e-6));
  if (!is_near(quarter, 0.8125, 1e-6)) UNSCOPED_INFO(gave);
  REQUIRE(is_near(quarter, 0.8125, 1e-6));
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    const Numbers table = exact_cdf(random_weights(random, 20));
    for (int i = 0; i < 200; ++i) {
      const double u = random.uniform();
      const double x = sample(table, u);
      const bool is_there = x >= 0 && x < 1 && is_near(true_cdf(table, x), u, 1e-6);
      if (!is_there)
        UNSCOPED_INFO("u = " << u << " gave x = " << x << ", where the distribution is "
                             << true_cdf(table, x) << ": " << text_of(table) << '.');
      REQUIRE(is_there);
      REQUIRE(pdf(table, x) > 0);
    }
  }
}

TEST_CASE("no sample lands in an empty bin, for no u") {
  REQUIRE(cumulative_and_find_bin_are_right());
  const Numbers cdf = exact_cdf(with_gaps);
  REQUIRE(pdf(cdf, 2.5 / 11) > 0);
  REQUIRE(is_near(sample(cdf, 0.125), (3 + 1.0 / 3) / 11, 1e-6));  // 1/16 into bin 3, 3/16 wide
  const auto landing = landing_in_empty_bin();
  lt::diagnose(!landing, "rounds-into-empty-bin", seen(landing));
  for (const Numbers& us : {on_edges(cdf), between_edges(cdf)})
    for (const double u : us) {
      INFO("u = " << text_of_u(u) << " in " << text_of(cdf) << " gave " << sample(cdf, u) << '.');
      REQUIRE(pdf(cdf, sample(cdf, u)) > 0);
    }
}

TEST_CASE("in the plane, a cell is as likely as its weight says") {
  REQUIRE(cumulative_and_find_bin_are_right());
  const auto turned = [](dvec2 u) { return dvec2(sample(small, u).y, sample(small, u).x); };
  const Numbers counts = cell_counts(in_small, 3, 2, 8);
  const std::string of_grid = "the rows {4, 0, 2} and {0, 1, 1}";
  const std::string gave = counts.empty() ? "in " + of_grid + " a place lies outside of the square."
                                          : "evenly spread u fill the cells of " + of_grid +
                                                " like " + text_of(counts, 3) + '.';
  lt::diagnose(!are_like(counts, small_rows_alike), "rows-equally-likely", gave);
  lt::diagnose(!are_like(counts, small_independent), "row-ignored-for-column", gave);
  lt::diagnose(
      are_like(counts, small.weights) || !are_like(cell_counts(turned, 3, 2, 8), small.weights),
      "x-and-y-exchanged", gave);
  if (!are_like(counts, small.weights)) UNSCOPED_INFO(gave);
  REQUIRE(are_like(counts, small.weights));

  const Numbers densities = cell_densities(small);
  const std::string density = "pdf() in the cells of " + of_grid + ", scaled to the sum 8, gave " +
                              text_of(densities, 3) + '.';
  const bool is_right = are_like(densities, small.weights);
  lt::diagnose(!are_like(densities, small_rows_alike), "row-density-forgotten", density);
  if (!is_right) UNSCOPED_INFO(density);
  REQUIRE(is_right);
}

TEST_CASE("in the plane, empty cells and rows stay empty, and all of a cell is used") {
  REQUIRE(cumulative_and_find_bin_are_right());
  REQUIRE(are_like(cell_counts(in_small, 3, 2, 8), small.weights));
  REQUIRE(are_like(cell_densities(small), small.weights));
  const double nothing = pdf(holes, {0.5, 0.1});
  lt::diagnose(!std::isnan(nothing), "empty-row-is-nan",
               "pdf() in a row without weight gave nan and should give 0.");
  const Numbers densities = cell_densities(holes);
  if (!are_like(densities, holes.weights))
    UNSCOPED_INFO("pdf() in cells with the weights " << text_of(holes.weights)
                                                     << ", 3 in a row, scaled to the sum 6, gave "
                                                     << text_of(densities) << '.');
  REQUIRE(are_like(densities, holes.weights));
  for (const dvec2 p : {dvec2(-0.1, 0.3), dvec2(1, 0.3), dvec2(0.5, -0.1), dvec2(0.5, 1)}) {
    INFO("at " << text_of(p));
    REQUIRE(pdf(small, p) == 0);
  }
  // Edges of the rows {0, 2, 0, 4, 0}, of the columns {1, 0, 3}, of all cells in a row, and u =
  // 1/2.
  for (const double v : {0.0, 1.0 / 3, 0.5, 1 - 0x1p-24, largest_u})
    for (const double u : {0.0, 0.25, 1.0 / 3, 0.5, 1 - 0x1p-24, largest_u}) {
      const dvec2 p = sample(holes, {u, v});
      INFO("u = (" << text_of_u(u) << ", " << text_of_u(v) << ") gave " << text_of(p) << '.');
      REQUIRE(pdf(holes, p) > 0);
    }
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    const int columns = 1 + static_cast<int>(random.next_bits() % 6);
    const int rows = 1 + static_cast<int>(random.next_bits() % 6);
    REQUIRE(is_right_at_random({columns, random_weights(random, columns * rows)}, seed));
    REQUIRE(is_right_at_random(holes, seed));
  }
  lt::measured("10,000 random places fell into 3 of 15 cells, and none into the 12 empty ones");
}
