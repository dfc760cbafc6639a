#include "ch04_monte_carlo/tabulated.hpp"

#include <numeric>
#include <vector>

#include "ch04_monte_carlo/dots.hpp"
#include "ch04_monte_carlo/pcg32.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

using Weights = std::vector<double>;

constexpr double largest_u = 1 - 0x1p-24;

double sum(const Weights& weights) {
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

// u on every edge of the table, a hair to both sides, and both ends of [0, 1).
Weights awkward_numbers(const Weights& weights) {
  Weights us{0.0, 0x1p-24, largest_u};
  for (const double edge : cumulative(weights))
    for (const double u : {edge - 0x1p-24, edge, edge + 0x1p-24})
      if (u >= 0 && u < 1) us.push_back(u);
  return us;
}

const Weights with_gaps{0, 0, 1, 3, 0, 2, 0, 0, 0, 4, 0};

}  // namespace

TEST_CASE("table: its cdf goes from 0 to exactly 1, whatever the weights") {
  for (const Weights& weights : {Weights{1}, Weights{0.1, 0.2, 0.3}, Weights(1000, 0.1), with_gaps,
                                 Weights{1e-300, 3e-300}, Weights{1e300, 1e-300, 1e300}}) {
    const Weights cdf = cumulative(weights);
    REQUIRE(cdf.size() == weights.size() + 1);
    CHECK(cdf.front() == 0);
    CHECK(cdf.back() == 1);
    for (std::size_t i = 0; i < weights.size(); ++i)
      CHECK(cdf[i] <= cdf[i + 1]);
  }
}

TEST_CASE("table: an empty bin is never returned, on no edge and at no end") {
  for (const Weights& weights :
       {with_gaps, Weights{0, 1}, Weights{1, 0}, Weights{0, 0, 5, 0}, Weights{1, 0, 0, 1},
        Weights{1e-30, 0, 1}, Weights{1, 0, 1e-30, 0}}) {
    const TabulatedDensity table(weights);
    for (const double u : awkward_numbers(weights)) {
      const int bin = find_bin(cumulative(weights), u);
      INFO("u = " << u << ", bin " << bin);
      REQUIRE(bin >= 0);
      REQUIRE(bin < table.bins());
      CHECK(weights[static_cast<std::size_t>(bin)] > 0);
      const double x = table.sample(u);
      CHECK(table.bin_at(x) == bin);
      CHECK(table.pdf(x) > 0);
      CHECK((x >= 0 && x < 1));
    }
  }
}

TEST_CASE("table: no sample slips into a neighbouring bin by rounding") {
  // 1/49 * 49 is less than 1 in double precision: the start of bin 1 is in bin 0.
  static_assert(1.0 / 49 * 49 < 1);
  Weights first_empty(49, 1.0);
  first_empty[0] = 0;
  const TabulatedDensity small(first_empty);
  CHECK(small.bin_at(small.sample(0)) == 1);

  Weights weights(100'000, 0.0);
  for (std::size_t i = 0; i < weights.size(); i += 2)
    weights[i] = 1;
  const TabulatedDensity table(weights);
  Pcg32 random(1);
  bool is_right = true;
  for (int i = 0; i < 1'000'000; ++i) {
    const double x = table.sample(random.next_float());
    is_right = is_right && table.bin_at(x) % 2 == 0;
  }
  for (const double u : awkward_numbers(weights))
    is_right = is_right && table.bin_at(table.sample(u)) % 2 == 0;
  CHECK(is_right);
}

TEST_CASE("table: pdf is weight over mean weight, and integrates to 1") {
  const TabulatedDensity table(with_gaps);
  const double mean = sum(with_gaps) / static_cast<double>(with_gaps.size());
  double integral = 0;
  for (int bin = 0; bin < table.bins(); ++bin) {
    const double x = (bin + 0.5) / table.bins();
    CHECK(table.pdf(x) == Approx(with_gaps[static_cast<std::size_t>(bin)] / mean));
    integral += table.pdf(x) / table.bins();
  }
  CHECK(integral == Approx(1));
  for (const double outside : {-0.1, 1.0, 1.1})
    CHECK(table.pdf(outside) == 0);
}

TEST_CASE("table: samples have the density (chi-square and Kolmogorov-Smirnov)") {
  const TabulatedDensity table(with_gaps);
  Pcg32 random(2);
  Weights samples, counts(with_gaps.size()), expected;
  for (int i = 0; i < 100'000; ++i) {
    samples.push_back(table.sample(random.next_float()));
    ++counts[static_cast<std::size_t>(table.bin_at(samples.back()))];
  }
  for (const double weight : with_gaps)
    expected.push_back(100'000 * weight / sum(with_gaps));
  CHECK(chi_square(counts, expected).p_value > 1e-6);
  CHECK(kolmogorov_smirnov(samples, [&](double x) { return table.cdf(x); }).p_value > 1e-6);
}

TEST_CASE("table: the cdf of a sample is u") {
  const TabulatedDensity table(with_gaps);
  Pcg32 random(3);
  for (int i = 0; i < 1000; ++i) {
    const double u = random.next_float();
    REQUIRE(table.cdf(table.sample(u)) == Approx(u).margin(1e-7));  // offsets stop at 1 - 2^-24
  }
  CHECK(table.cdf(-0.5) == 0);
  CHECK(table.cdf(1.5) == 1);
}

TEST_CASE("table in the plane: empty cells and empty rows are never returned") {
  const Weights weights{0, 0, 0,  //
                        0, 2, 0,  //
                        0, 0, 0,  //
                        1, 0, 3,  //
                        0, 0, 0};
  const TabulatedDensity2D table(weights, 3);
  Weights counts(weights.size());
  const auto take = [&](glm::dvec2 u) {
    const glm::dvec2 p = table.sample(u);
    REQUIRE((p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1));
    REQUIRE(table.pdf(p) > 0);
    ++counts[static_cast<std::size_t>(p.y * 5) * 3 + static_cast<std::size_t>(p.x * 3)];
  };
  for (const double u : awkward_numbers({0, 2, 0, 4, 0}))
    for (const double v : awkward_numbers({1, 0, 3}))
      take({v, u});
  CHECK(counts[4] + counts[9] + counts[11] == sum(counts));

  counts.assign(counts.size(), 0);
  Pcg32 random(4);
  for (int i = 0; i < 60'000; ++i)
    take(random.next_vec2());
  Weights expected;
  for (const double weight : weights)
    expected.push_back(10'000 * weight);
  CHECK(chi_square(counts, expected).p_value > 1e-6);
}

TEST_CASE("table in the plane: pdf is weight over mean weight, 0 outside") {
  const Weights weights{1, 2, 3, 0, 0, 0, 4, 0, 2};
  const TabulatedDensity2D table(weights, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x)
      CHECK(table.pdf({(x + 0.5) / 3, (y + 0.5) / 3}) ==
            Approx(weights[static_cast<std::size_t>(3 * y + x)] * 9 / 12));
  for (const glm::dvec2 outside : {glm::dvec2(-0.1, 0.5), glm::dvec2(0.5, 1), glm::dvec2(1, 0.5)})
    CHECK(table.pdf(outside) == 0);
}

TEST_CASE("dots: fall where the picture is bright, and never where it is black") {
  Image picture(2, 2);
  picture.at(1, 0) = Rgb(0.25f);
  picture.at(0, 1) = Rgb(0.75f);
  const TabulatedDensity2D density = picture_density(picture);
  CHECK(density.pdf({0.75, 0.25}) == Approx(1));  // a quarter of the dots in a quarter of the area
  CHECK(density.pdf({0.25, 0.75}) == Approx(3));
  CHECK(density.pdf({0.25, 0.25}) == 0);
}
