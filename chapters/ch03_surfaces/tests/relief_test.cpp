#include "ch03_surfaces/relief.hpp"

#include <cmath>

#include "common/testkit/catch.hpp"

using namespace lt;

TEST_CASE("relief: a flat height field has the flat normal map, exactly") {
  HeightField heights(4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      heights.at(x, y) = 0.7f;
  const Image normals = normals_of(heights);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      CHECK(normals.at(x, y) == vec3(0.5f, 0.5f, 1.0f));
}

TEST_CASE("relief: what rises to the right leans left and what rises downward leans up") {
  // Slope 3/4 along u, then along v: the 3-4-5 triangle.
  HeightField right(8), down(8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      right.at(x, y) = 0.75f * static_cast<float>(x) / 8.0f;
      down.at(x, y) = 0.75f * static_cast<float>(y) / 8.0f;
    }
  for (int i = 1; i < 7; ++i) {  // not at the edges, where the ramp starts again
    CHECK(glm::distance(normal_at(right, i, 3), vec3(-0.6f, 0.0f, 0.8f)) < 1e-6f);
    CHECK(glm::distance(normal_at(down, 3, i), vec3(0.0f, -0.6f, 0.8f)) < 1e-6f);
  }
}

TEST_CASE("relief: waves have the analytic normal, across the edges too") {
  // h = a sin(2 pi (u + 2 v)): slopes a 2 pi cos and twice that. Central differences shorten them
  // by sin(d) / d, d the phase step of a texel: at most d^2 / 6 = 4e-4 for 2 * 2 pi / 256.
  const int size = 256;
  const float a = 0.1f;
  HeightField heights(size);
  const auto phase = [&](int x, int y) {
    return 2.0f * pi * static_cast<float>(x + 2 * y) / static_cast<float>(size);
  };
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      heights.at(x, y) = a * std::sin(phase(x, y));
  const Image normals = normals_of(heights);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const float slope = a * 2.0f * pi * std::cos(phase(x, y));
      const vec3 expected = normalize(vec3(-slope, -2.0f * slope, 1.0f));
      REQUIRE(glm::distance(normals.at(x, y) * 2.0f - 1.0f, expected) < 6e-4f);
    }
}

TEST_CASE("paint: asks once at the middle of each texel, u to the right and v down") {
  const auto pattern = [](vec2 uv) { return PatternPoint{Rgb(uv, 2.0f), 0.0f}; };
  const TextureMaps maps = paint(pattern, 4);
  CHECK(maps.color.at(0, 0) == Rgb(0.125f, 0.125f, 1.0f));  // and 2 is no reflectance
  CHECK(maps.color.at(3, 0) == Rgb(0.875f, 0.125f, 1.0f));
  CHECK(maps.color.at(1, 2) == Rgb(0.375f, 0.625f, 1.0f));
  CHECK(maps.normals.at(1, 2) == vec3(0.5f, 0.5f, 1.0f));
}

TEST_CASE("round_box: distances to sides and corners") {
  const vec2 half(3.0f, 2.0f);
  CHECK(round_box({0.0f, 0.0f}, half, 0.5f) == Approx(-2.0f));  // the nearest side
  CHECK(round_box({5.0f, 1.0f}, half, 0.5f) == Approx(2.0f));
  CHECK(round_box({-1.0f, -2.0f}, half, 0.5f) == Approx(0.0f).margin(1e-6));
  // The corner's circle has its middle at (2.5, 1.5).
  CHECK(round_box({2.5f + 3.0f, 1.5f + 4.0f}, half, 0.5f) == Approx(5.0f - 0.5f));
}
