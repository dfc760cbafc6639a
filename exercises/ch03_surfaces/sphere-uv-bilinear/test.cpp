#include "api.hpp"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::bilinear;
using exercise::sphere_uv;
using exercise::Texture;
using glm::dvec2;
using glm::dvec3;

const double pi = std::acos(-1.0);

bool is_near(double a, double b, double tolerance = 1e-9) {
  return std::abs(a - b) <= tolerance;
}

std::string gave(const std::string& call, double value, double expected) {
  std::ostringstream text;
  text << call << " gave " << value << " and should give " << expected << ".";
  return text.str();
}

// What bilinear() gives; NaN if it asks for a texel that is not there.
double looked_up(const Texture& texture, dvec2 uv) {
  try {
    return bilinear(texture, uv);
  } catch (const std::out_of_range&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

const Texture row{4, 1, {10, 20, 40, 80}};

// sphere_uv() read backwards.
dvec3 normal_at(dvec2 uv) {
  const double longitude = 2.0 * pi * (uv.x - 0.5);
  const double r = std::sin(pi * uv.y);
  return {r * std::sin(longitude), std::cos(pi * uv.y), -r * std::cos(longitude)};
}

}  // namespace

TEST_CASE("the six points on the axes have their place on the picture") {
  const dvec2 right = sphere_uv({1, 0, 0});
  const dvec2 upper = sphere_uv(normal_at({0.5, 0.25}));
  lt::diagnose(!is_near(right.x, 0.25), "u-mirrored", gave("u of (1, 0, 0)", right.x, 0.75));
  lt::diagnose(!is_near(upper.y, 0.75), "v-from-south",
               gave("v of (0, 0.707, -0.707)", upper.y, 0.25));
  CHECK(is_near(right.x, 0.75));
  CHECK(is_near(right.y, 0.5));
  CHECK(is_near(sphere_uv({0, 0, -1}).x, 0.5));
  CHECK(is_near(sphere_uv({0, 0, -1}).y, 0.5));
  CHECK(is_near(sphere_uv({-1, 0, 0}).x, 0.25));
  CHECK(is_near(sphere_uv({0, 1, 0}).y, 0.0));
  CHECK(is_near(sphere_uv({0, -1, 0}).y, 1.0));
  const double back = sphere_uv({0, 0, 1}).x;  // on the seam: either end will do
  CHECK((is_near(back, 0.0) || is_near(back, 1.0)));
}

TEST_CASE("normals a hair longer than 1 have a place too") {
  const double v = sphere_uv({0, 1.0 + 1e-15, 0}).y;
  lt::diagnose(!std::isnan(v), "acos-not-clamped", gave("v of (0, 1.000000000000001, 0)", v, 0));
  for (const double y : {1.0 + 1e-15, -1.0 - 1e-15})
    for (const double x : {0.0, -0.0, 1e-300, -1e-20}) {
      const dvec2 uv = sphere_uv({x, y, 0.0});
      CHECK((uv.x >= 0.0 && uv.x <= 1.0 && uv.y >= 0.0 && uv.y <= 1.0));
    }
}

TEST_CASE("every point of the sphere comes back from its place on the picture") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      const dvec3 n = random.direction();
      REQUIRE(distance(normal_at(sphere_uv(n)), n) < 1e-6);  // acos: half the digits at the poles
    }
  }
}

TEST_CASE("the middle of a texel is that texel") {
  const double middle = looked_up(row, {1.5 / 4, 0.5});
  // Half a texel off, either way, is the mean with a neighbour: (10 + 20) / 2 or (20 + 40) / 2.
  lt::diagnose(!is_near(middle, 15) && !is_near(middle, 30), "half-texel-shift",
               gave("the middle of the second of 10 20 40 80", middle, 20));
  CHECK(is_near(middle, 20));
  const Texture odd{5, 3, {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9}};
  for (int y = 0; y < odd.height; ++y)
    for (int x = 0; x < odd.width; ++x)
      CHECK(is_near(bilinear(odd, {(x + 0.5) / odd.width, (y + 0.5) / odd.height}), odd.at(x, y)));
}

TEST_CASE("to the left of the picture it begins again") {
  const double left = looked_up(row, {-0.25, 0.5});
  const double same = looked_up(row, {0.75, 0.5});
  lt::diagnose(!(std::isnan(left) && !std::isnan(same)), "negative-modulo",
               "u = -0.25 asks for a texel that is not there and should find what is at 0.75.");
  const double edge = looked_up(row, {0.0, 0.5});
  // Half a texel before the first middle, the mean of the last and the first texel is (80 + 10)
  // / 2. With the fraction -0.5 between texels 0 and 1 it is 10 - (20 - 10) / 2.
  lt::diagnose(!is_near(edge, 5), "truncated-not-floored", gave("u = 0 of 10 20 40 80", edge, 45));
  CHECK(is_near(left, same));
  CHECK(is_near(edge, 45));
  CHECK(is_near(bilinear(row, {1.0, 0.5}), 45));
  CHECK(is_near(bilinear(row, {-3.625, -2.5}), 20));
  CHECK(is_near(bilinear(row, {7.375, 4.5}), 20));
}

TEST_CASE("a ramp stays a ramp between the texels") {
  Texture ramp{8, 8, {}};
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      ramp.values.push_back(3.0 + 2.0 * x - 5.0 * y);
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      const double x = random.uniform(0, 7);
      const double y = random.uniform(0, 7);
      REQUIRE(is_near(bilinear(ramp, {(x + 0.5) / 8, (y + 0.5) / 8}), 3.0 + 2.0 * x - 5.0 * y));
    }
  }
  const Texture one{1, 1, {7.0}};
  CHECK(is_near(bilinear(one, {-0.3, 12.9}), 7.0));
  std::ostringstream text;
  text << "at the left edge of 10 20 40 80 there is " << bilinear(row, {0.0, 0.5})
       << ", the mean of the first texel and the last";
  lt::measured(text.str());
}
