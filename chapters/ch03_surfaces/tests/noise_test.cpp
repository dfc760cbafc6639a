#include "ch03_surfaces/noise.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "common/testkit/catch.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;

namespace {

/// Points of [-2, 2)^2: noise repeats, so any square will do.
std::vector<vec2> random_points(int count) {
  std::mt19937 engine(3);
  std::vector<vec2> points;
  for (int i = 0; i < count; ++i) {
    const float u = static_cast<float>(engine() >> 8) * 0x1p-22f - 2.0f;
    const float v = static_cast<float>(engine() >> 8) * 0x1p-22f - 2.0f;
    points.emplace_back(u, v);
  }
  return points;
}

/// So many cells that no two samples share one: independent samples.
constexpr ivec2 many_cells(1 << 14, 1 << 14);

/// E[noise^2] by hand. The value is the sum over a cell's corners of
///   w(x) w(y) (slope . (x, y)),  w(t) = 1 - smoother(t), (x, y) counted from that corner.
/// Slopes are independent and uniform in [-1, 1], so E[slope^2] = 1/3 and mixed terms vanish:
///   E = 4 corners * 1/3 * (integral of w^2 x^2) (integral of w^2) * 2 directions.
double mean_square_of_noise() {
  const auto w = [](double t) { return 1.0 - t * t * t * (t * (t * 6.0 - 15.0) + 10.0); };
  const double a = integrate([&](double t) { return w(t) * w(t) * t * t; }, 0, 1);
  const double b = integrate([&](double t) { return w(t) * w(t); }, 0, 1);
  return 4.0 / 3.0 * a * b * 2.0;
}

}  // namespace

TEST_CASE("scramble: one flipped bit going in flips each bit coming out half of the time") {
  constexpr int trials = 4096;
  for (int in = 0; in < 32; ++in) {
    std::array<int, 32> flips{};
    for (std::uint32_t trial = 0; trial < trials; ++trial) {
      const std::uint32_t changed = scramble(trial) ^ scramble(trial ^ (1U << in));
      for (int out = 0; out < 32; ++out)
        flips[out] += changed >> out & 1U;
    }
    // Standard error of a share of 1/2 is 1 / (2 sqrt(trials)).
    for (int out = 0; out < 32; ++out) {
      INFO("bit " << in << " in, bit " << out << " out");
      CHECK(std::abs(flips[out] / double(trials) - 0.5) < 6.0 * 0.5 / std::sqrt(trials));
    }
  }
}

TEST_CASE("cell_random: uniform in 0 to 1 over columns and rows and seeds") {
  std::vector<double> columns, rows, seeds;
  for (int i = 0; i < 20000; ++i) {
    columns.push_back(cell_random(i, 7, 1));
    rows.push_back(cell_random(7, i, 1));
    seeds.push_back(cell_random(7, 7, i));
  }
  const auto uniform = [](double x) { return x; };
  CHECK(kolmogorov_smirnov(columns, uniform).p_value > 1e-6);
  CHECK(kolmogorov_smirnov(rows, uniform).p_value > 1e-6);
  CHECK(kolmogorov_smirnov(seeds, uniform).p_value > 1e-6);
}

TEST_CASE("cell_random: a cell says nothing about its neighbours") {
  RunningMean right, below, next_seed;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const double here = cell_random(x, y, 5) - 0.5;
      right.add(here * (cell_random(x + 1, y, 5) - 0.5));
      below.add(here * (cell_random(x, y + 1, 5) - 0.5));
      next_seed.add(here * (cell_random(x, y, 6) - 0.5));
    }
  CHECK(z_test(right, 0.0).agrees());
  CHECK(z_test(below, 0.0).agrees());
  CHECK(z_test(next_seed, 0.0).agrees());
}

TEST_CASE("on_grid: names the cell and the place in it and repeats in all directions") {
  for (const vec2 period : {vec2(0, 0), vec2(1, 0), vec2(0, -1), vec2(-3, 2)}) {
    const GridPoint point = on_grid(vec2(0.6875f, 0.125f) + period, {8, 2});
    CHECK(point.cell == ivec2(5, 0));
    CHECK(point.within == vec2(0.5f, 0.25f));
  }
  // The nearest float below 0 wraps to 1 exactly: the first cell again, not one too many.
  CHECK(on_grid(vec2(-1e-30f, 0.0f), {8, 2}).cell == ivec2(0, 0));
}

TEST_CASE("noise: with one cell it is the closed form") {
  // All four corners are the same one, with slopes s. The blend of s.x * x and s.x * (x - 1) with
  // weight smoother(x) is s.x * (x - smoother(x)), and the same for y.
  const std::uint32_t bits = cell_bits(0, 0, 9);
  const vec2 slope = vec2(bits & 0xffffU, bits >> 16) / 32767.5f - 1.0f;
  for (const vec2 p : {vec2(0.25f, 0.5f), vec2(0.125f, 0.75f), vec2(0.9f, 0.3f)}) {
    const float expected = slope.x * (p.x - smoother(p.x)) + slope.y * (p.y - smoother(p.y));
    CHECK(noise(p, {1, 1}, 9) == Approx(expected).margin(1e-6));
  }
}

TEST_CASE("noise: zero where the grid lines cross") {
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x)
      CHECK(noise(vec2(x / 8.0f, y / 4.0f), {8, 4}, 1) == 0.0f);
}

TEST_CASE("noise: within -1 and 1 with mean 0 and the variance of its definition") {
  RunningMean mean, square;
  for (const vec2 uv : random_points(100000)) {
    const double value = noise(uv, many_cells, 2);
    REQUIRE(std::abs(value) <= 1.0);
    mean.add(value);
    square.add(value * value);
  }
  CHECK(z_test(mean, 0.0).agrees());
  CHECK(z_test(square, mean_square_of_noise()).agrees(0.002));
}

TEST_CASE("fbm: within -1 and 1 with mean 0 and the sum of its octaves' variances") {
  RunningMean mean, square;
  for (const vec2 uv : random_points(50000)) {
    const double value = fbm(uv, many_cells / 8, 4, 2);
    REQUIRE(std::abs(value) <= 1.0);
    mean.add(value);
    square.add(value * value);
  }
  CHECK(z_test(mean, 0.0).agrees());
  const double shares = 1.0 / 4 + 1.0 / 16 + 1.0 / 64 + 1.0 / 256;  // amplitudes squared
  CHECK(z_test(square, shares * mean_square_of_noise()).agrees(0.002));
}

TEST_CASE("pits: as many as asked for and round") {
  // A pit's radius is r = 0.1 + 0.3 t^2 with t uniform: E[r^2] = 0.01 + 0.06 / 3 + 0.09 / 5. Its
  // depth at a distance d is (r / 0.4) (1 - d^2 / r^2): volume (r / 0.4) pi r^2 / 2, and
  // E[r^3] = 0.001 + 3 * 0.01 * 0.3 / 3 + 3 * 0.1 * 0.09 / 5 + 0.027 / 7.
  const double share = 0.4;
  const double area = 0.01 + 0.06 / 3 + 0.09 / 5;
  const double cube = 0.001 + 0.003 + 0.0054 + 0.027 / 7;
  RunningMean covered, depth;
  for (const vec2 uv : random_points(100000)) {
    const double pit = pits(uv, many_cells, share, 4);
    REQUIRE(pit >= 0.0);
    REQUIRE(pit <= 1.0);
    covered.add(pit > 0.0);
    depth.add(pit);
  }
  CHECK(z_test(covered, share * std::numbers::pi * area).agrees(0.002));
  CHECK(z_test(depth, share * std::numbers::pi * cube / 0.8).agrees(0.002));
}

TEST_CASE("noise and fbm and pits: opposite edges fit together") {
  // Steps of 1e-4 across the seam may change the value by the slope times that: noise of n cells
  // has slopes up to about 4 n (blended planes), pits up to 2 / 0.4 n.
  const float step = 1e-4f;
  for (int i = 0; i < 200; ++i) {
    const float t = static_cast<float>(i) / 200.0f;
    for (const bool upright : {true, false}) {
      const vec2 before = upright ? vec2(1.0f - step / 2, t) : vec2(t, 1.0f - step / 2);
      const vec2 after = upright ? vec2(step / 2, t) : vec2(t, step / 2);
      CHECK(std::abs(noise(before, {5, 3}, 1) - noise(after, {5, 3}, 1)) < 20 * step);
      CHECK(std::abs(fbm(before, {5, 3}, 3, 1) - fbm(after, {5, 3}, 3, 1)) < 30 * step);
      CHECK(std::abs(pits(before, {5, 3}, 1, 1) - pits(after, {5, 3}, 1, 1)) < 25 * step);
    }
  }
}

TEST_CASE("noise: the same seed gives the same hills and another seed gives others") {
  RunningMean product;
  for (const vec2 uv : random_points(20000)) {
    REQUIRE(noise(uv, many_cells, 1) == noise(uv, many_cells, 1));
    product.add(noise(uv, many_cells, 1) * noise(uv, many_cells, 2));
  }
  CHECK(z_test(product, 0.0).agrees());
}
