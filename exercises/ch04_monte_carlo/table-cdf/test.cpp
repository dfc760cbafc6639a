#include "api.hpp"

#include <algorithm>
#include <cmath>
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

// Six digits; numbers that come nearer to 1 in full.
std::string text_of(double x) {
  std::ostringstream text;
  text.precision(x < 1 && x > 0.9999995 ? 17 : 6);
  text << (std::isnan(x) ? std::abs(x) : x);
  return x == largest_u ? "1 - 2^-53" : text.str();
}

std::string text_of(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : ", ") + text_of(number);
  return "{" + text + "}";
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
const Numbers ten_and_none{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0};

// A third of them 0, but never all.
Numbers random_weights(lt::TestRandom& random, int n) {
  Numbers weights;
  for (int i = 0; i < n; ++i)
    weights.push_back(random.uniform() < 0.35 ? 0.0 : random.uniform());
  weights[random.next_bits() % weights.size()] = 0.5;
  return weights;
}

Numbers on_edges(Numbers cdf) {
  std::erase(cdf, 1.0);
  return cdf;
}

Numbers between_edges(const Numbers& cdf) {
  Numbers us{1 - 0x1p-24, largest_u};
  for (std::size_t i = 1; i < cdf.size(); ++i)
    if (cdf[i] > cdf[i - 1]) us.push_back((cdf[i] + cdf[i - 1]) / 2);
  return us;
}

// The first u whose bin is not the one of the definition, or as many beyond it as `shift` says.
std::optional<double> wrong_u(const Numbers& cdf, const Numbers& us, int shift = 0) {
  for (const double u : us) {
    const int bin = find_bin(cdf, u) - shift;
    const bool is_bin = bin >= 0 && bin + 1 < static_cast<int>(cdf.size());
    if (!is_bin || !(cdf[bin] <= u && u < cdf[bin + 1])) return u;
  }
  return std::nullopt;
}

std::string gave_bin(const Numbers& cdf, std::optional<double> u) {
  if (!u) return "";
  const auto above = std::find_if(cdf.begin(), cdf.end(), [&](double edge) { return edge > *u; });
  return "find_bin(" + text_of(cdf) + ", " + text_of(*u) + ") gave " +
         std::to_string(find_bin(cdf, *u)) + " and should give " +
         std::to_string(above - cdf.begin() - 1) + ".";
}

bool finds_bins(const Numbers& cdf, const Numbers& us) {
  const auto u = wrong_u(cdf, us);
  if (u) UNSCOPED_INFO(gave_bin(cdf, u));
  return !u;
}

// What places and planes stand on: without it they would run into walls.
bool sums_and_bins_are_right() {
  const Numbers cdf = exact_cdf(with_gaps);
  return cumulative(four) == exact_cdf(four) && cumulative(ten_and_none)[10] == 1 &&
         finds_bins(cdf, between_edges(cdf)) && finds_bins(cdf, on_edges(cdf));
}

std::string gave_place(const Numbers& cdf, double u, double expected) {
  return "sample(" + text_of(cdf) + ", " + text_of(u) + ") gave " + text_of(sample(cdf, u)) +
         " and should give " + text_of(expected) + ".";
}

bool finds_place(const Numbers& cdf, double u, double expected) {
  const bool is_right = is_near(sample(cdf, u), expected, 1e-6);
  if (!is_right) UNSCOPED_INFO(gave_place(cdf, u, expected));
  return is_right;
}

// A sample on an edge whose density is 0, in words. Looked for in tables of 2 to 200 bins that are
// empty at one end, where the other bins begin.
std::string landing_in_empty_bin() {
  for (std::size_t bins = 2; bins <= 200; ++bins)
    for (const bool is_first : {true, false}) {
      Numbers weights(bins, 1.0);
      (is_first ? weights.front() : weights.back()) = 0;
      const Numbers cdf = exact_cdf(weights);
      for (const double u : {0.0, largest_u}) {
        const double x = sample(cdf, u);
        const double edge = x * static_cast<double>(bins);
        if (pdf(cdf, x) > 0 || !is_near(edge, std::round(edge))) continue;
        return "of " + std::to_string(bins) + " bins the " + (is_first ? "first" : "last") +
               " is empty and the others are alike; u = " + text_of(u) + " gave x = " + text_of(x) +
               ", where pdf() is 0.";
      }
    }
  return "";
}

// Rows {4, 0, 2} and {0, 1, 1}: no row is empty, no column, and the rows differ.
const Grid small{3, {4, 0, 2, 0, 1, 1}};
const Numbers small_rows_alike{8.0 / 3, 0, 4.0 / 3, 0, 2, 2};   // each row half of 8
const Numbers small_independent{3, 0.75, 2.25, 1, 0.25, 0.75};  // rows 6, 2 times columns 4, 1, 3
// Empty rows at both ends and between, and empty cells in each row.
const Grid holes{3, {0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0}};

// Places for 120 x 120 evenly spread u.
std::vector<dvec2> even_places(const Grid& grid) {
  std::vector<dvec2> places;
  for (int i = 0; i < 120 * 120; ++i)
    places.push_back(sample(grid, (dvec2(i % 120, i / 120) + 0.5) / 120.0));
  return places;
}

// How much of a total of `sum` falls into each of columns x rows cells; nothing if a place is none.
Numbers shares(const std::vector<dvec2>& places, int columns, int rows, double sum) {
  Numbers all(static_cast<std::size_t>(columns) * rows);
  for (const dvec2 p : places) {
    if (!(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1)) return {};
    all[static_cast<int>(p.y * rows) * columns + static_cast<int>(p.x * columns)] +=
        sum / static_cast<double>(places.size());
  }
  return all;
}

// Each edge of a cell may take or leave one row of u: 120 of 14,400, 0.07 of a sum of 8.
bool are_like(const Numbers& a, const Numbers& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return is_near(x, y, 0.15); });
}

// The densities in the middles of the cells, as weights.
Numbers densities(const Grid& grid) {
  const double cells = static_cast<double>(grid.weights.size());
  const double sum = std::accumulate(grid.weights.begin(), grid.weights.end(), 0.0);
  Numbers all;
  for (int i = 0; i < static_cast<int>(grid.weights.size()); ++i)
    all.push_back(sum / cells *
                  pdf(grid, {(i % grid.columns + 0.5) / grid.columns,
                             (i / grid.columns + 0.5) * grid.columns / cells}));
  return all;
}

// 10,000 random places against the weights, each cell in four parts (chi-square).
bool is_right_at_random(const Grid& grid, std::uint64_t seed) {
  lt::TestRandom random(seed);
  std::vector<dvec2> places;
  for (int i = 0; i < 10'000; ++i) {
    const double u = random.uniform();
    places.push_back(sample(grid, {u, random.uniform()}));
  }
  const int columns = 2 * grid.columns;
  const int rows = 2 * static_cast<int>(grid.weights.size()) / grid.columns;
  const double sum = std::accumulate(grid.weights.begin(), grid.weights.end(), 0.0);
  Numbers expected;
  for (int i = 0; i < columns * rows; ++i)
    expected.push_back(grid.weights[i / columns / 2 * grid.columns + i % columns / 2] / sum * 2500);
  const Numbers counts = shares(places, columns, rows, 10'000);
  if (!counts.empty() && lt::chi_square(counts, expected).p_value > 1e-6) return true;
  UNSCOPED_INFO(columns << " x " << rows << " quarters of cells hold " << text_of(counts)
                        << " places and should hold about " << text_of(expected) << '.');
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
