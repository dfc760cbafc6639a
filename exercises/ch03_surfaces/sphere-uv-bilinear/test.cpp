#include "api.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::bilinear;
using exercise::sphere_uv;
using exercise::Texture;
using glm::dvec2;
using glm::dvec3;
using lt::close_to;

const double pi = std::acos(-1.0);

std::string gave(const std::string& call, double value, double expected) {
  std::ostringstream text;
  text << call << " gave " << value << " and should give " << expected << ".";
  return text.str();
}

// True if bilinear() asks for a texel that is not there.
bool asks_too_far(const Texture& texture, dvec2 uv) {
  try {
    (void)bilinear(texture, uv);
    return false;
  } catch (const std::out_of_range&) {
    return true;
  }
}

// Both with the same four values: 10 20 40 80.
const Texture row{4, 1, {10, 20, 40, 80}};
const Texture column{1, 4, {10, 20, 40, 80}};
const Texture square{2, 2, {10, 20, 40, 80}};

// True if u chooses the row and v the column.
bool columns_are_rows() {
  return bilinear(square, {0.25, 0.25}) == close_to(10.0) &&
         bilinear(square, {0.75, 0.25}) == close_to(40.0);
}

// sphere_uv() read backwards.
dvec3 normal_at(dvec2 uv) {
  const double longitude = 2.0 * pi * (uv.x - 0.5);
  const double r = std::sin(pi * uv.y);
  return {r * std::sin(longitude), std::cos(pi * uv.y), -r * std::cos(longitude)};
}

}  // namespace

TEST_CASE("the six points on the axes have their place on the picture") {
  const double front = sphere_uv({0, 0, -1}).x;
  const double right = sphere_uv({1, 0, 0}).x;
  const double upper = sphere_uv(normal_at({0.5, 0.25})).y;
  // Between the axes: u = 0.5 - 0.102 to the left of the front, 0.5 + 0.102 to its right, and half
  // a turn further than on the left at the point across from there. An arc tangent of a quotient
  // sees the same quotient at both.
  const double near_left = sphere_uv({-0.6, 0, -0.8}).x;
  const double near_right = sphere_uv({0.6, 0, -0.8}).x;
  const double across = sphere_uv({0.6, 0, 0.8}).x;
  const double aside = std::atan(0.75) / (2.0 * pi);
  const bool knows_half =
      across == close_to(near_left) && std::abs(near_right - near_left) == close_to(2.0 * aside);
  lt::diagnose(!knows_half, "atan-knows-half-the-circle",
               gave("u of (0.6, 0, 0.8)", across, 1.0 - aside));
  lt::diagnose(
      !(front == close_to(0.0) && right == close_to(0.25) && near_left == close_to(-aside)),
      "u-below-zero", gave("u of (-0.6, 0, -0.8)", near_left, 0.5 - aside));
  // atan2(-z, x) is a quarter of a turn minus atan2(x, -z).
  lt::diagnose(!(front == close_to(0.75) && near_right == close_to(0.75 - aside)),
               "atan2-arguments-swapped", gave("u of (0, 0, -1)", front, 0.5));
  lt::diagnose(std::isnan(front) || front == close_to(0.5), "front-not-in-the-middle",
               gave("u of (0, 0, -1)", front, 0.5));
  lt::diagnose(!(right == close_to(0.25) && near_right == close_to(0.5 - aside)), "u-mirrored",
               gave("u of (1, 0, 0)", right, 0.75));
  lt::diagnose(!(upper == close_to(0.75)), "v-from-south",
               gave("v of (0, 0.707, -0.707)", upper, 0.25));
  CHECK(sphere_uv({0, 0, -1}) == close_to(dvec2(0.5, 0.5)));
  CHECK(sphere_uv({1, 0, 0}) == close_to(dvec2(0.75, 0.5)));
  CHECK(sphere_uv({-1, 0, 0}) == close_to(dvec2(0.25, 0.5)));
  CHECK(sphere_uv({0, 1, 0}).y == close_to(0.0));
  CHECK(sphere_uv({0, -1, 0}).y == close_to(1.0));
  const double back = sphere_uv({0, 0, 1}).x;  // on the seam: either end will do
  CHECK(std::abs(back - 0.5) == close_to(0.5));
}

TEST_CASE("normals a hair longer than 1 have a place too") {
  const double v = sphere_uv({0, 1.0 + 1e-15, 0}).y;
  const bool is_right_at_1 = sphere_uv({0, 1, 0}).y == close_to(0.0);
  lt::diagnose(!(std::isnan(v) && is_right_at_1), "acos-not-clamped",
               gave("v of (0, 1.000000000000001, 0)", v, 0));
  for (const double y : {1.0 + 1e-15, -1.0 - 1e-15})
    for (const double x : {0.0, -0.0, 1e-300, -1e-20}) {
      const dvec2 uv = sphere_uv({x, y, 0.0});
      INFO("normal (" << x << ", " << y << ", 0)");
      CHECK(uv.x >= 0.0);
      CHECK(uv.x <= 1.0);
      CHECK(uv.y == close_to(y > 0 ? 0.0 : 1.0));
    }
}

TEST_CASE("every point of the sphere comes back from its place on the picture") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      const dvec3 n = random.direction();
      const dvec2 uv = sphere_uv(n);
      INFO("sphere_uv gave (" << uv.x << ", " << uv.y << ")");
      REQUIRE(n == close_to(normal_at(uv)));
    }
  }
}

TEST_CASE("the middle of a texel is that texel") {
  INFO("row is 10 20 40 80");
  lt::diagnose(!columns_are_rows(), "columns-are-rows",
               gave("the middle of the upper right texel of 10 20 above 40 80", 40, 20));
  const double middle = bilinear(row, {1.5 / 4, 0.5});
  const double quarter = bilinear(row, {1.75 / 4, 0.5});
  // 20 / 4 + 40 * 3 / 4, and at the middle the next texel alone.
  lt::diagnose(!(middle == close_to(40.0) && quarter == close_to(35.0)), "weights-reversed",
               gave("a quarter of the way from 20 to 40", quarter, 25));
  const std::string seen = gave("the middle of the second of 10 20 40 80", middle, 20);
  // Half a texel off, either way, is the mean with a neighbour: (10 + 20) / 2 or (20 + 40) / 2.
  const bool is_shifted = middle == close_to(15.0) || middle == close_to(30.0);
  lt::diagnose(!is_shifted || columns_are_rows(), "half-texel-shift", seen);
  // 1.5 / 4 of 4 - 1 texels is 1.125: 20 + 0.125 * (40 - 20).
  lt::diagnose(!(middle == close_to(22.5)), "one-texel-less", seen);
  CHECK(bilinear(row, {1.5 / 4, 0.5}) == close_to(20.0));
  const Texture odd{5, 3, {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9}};
  for (int y = 0; y < odd.height; ++y)
    for (int x = 0; x < odd.width; ++x) {
      INFO("texel (" << x << ", " << y << ") of 5 x 3");
      CHECK(bilinear(odd, {(x + 0.5) / odd.width, (y + 0.5) / odd.height}) ==
            close_to(odd.at(x, y)));
    }
}

TEST_CASE("a quarter of the way to the next texel, that one has a quarter of the weight") {
  INFO("square is 10 20 above 40 80");
  const double to_right = bilinear(square, {0.375, 0.25});
  const double down = bilinear(square, {0.25, 0.375});
  // 10 + (20 - 10) / 4 and 10 + (40 - 10) / 4.
  const bool is_turned = to_right == close_to(17.5) && down == close_to(12.5);
  lt::diagnose(
      !is_turned || columns_are_rows(), "right-is-below",
      gave("a quarter of the way from 10 to 20 on its right, with 40 below 10,", to_right, 12.5));
  CHECK(bilinear(square, {0.375, 0.25}) == close_to(12.5));
  CHECK(bilinear(square, {0.25, 0.375}) == close_to(17.5));
}

TEST_CASE("beyond its edges the picture begins again") {
  INFO("row is 10 20 40 80, column the same from the top down");
  // Past the right edge the remainder does its work; only past the left edge it is negative.
  lt::diagnose(!asks_too_far(row, {-0.25, 0.5}) || asks_too_far(row, {1.25, 0.5}),
               "negative-modulo",
               "u = -0.25 asks for a texel that is not there and should find what is at 0.75.");
  const double edge = bilinear(row, {0.0, 0.5});
  const bool is_right_inside = bilinear(row, {1.5 / 4, 0.5}) == close_to(20.0);
  // Half a texel before the first middle, the mean of the last and the first texel is (80 + 10) /
  // 2. Truncated, texel -1 becomes 0: with the fraction -0.5 that is 10 - (20 - 10) / 2, with 0.5
  // it is (10 + 20) / 2.
  lt::diagnose(!(is_right_inside && (edge == close_to(5.0) || edge == close_to(15.0))),
               "truncated-not-floored", gave("u = 0 of 10 20 40 80", edge, 45));
  CHECK(bilinear(row, {0.0, 0.5}) == close_to(45.0));
  CHECK(bilinear(row, {1.0, 0.5}) == close_to(45.0));
  CHECK(bilinear(row, {-0.25, 0.5}) == close_to(60.0));  // as at 0.75: (40 + 80) / 2
  CHECK(bilinear(row, {-3.625, -2.5}) == close_to(20.0));
  CHECK(bilinear(row, {7.375, 4.5}) == close_to(20.0));
  CHECK(bilinear(column, {0.5, 0.0}) == close_to(45.0));
  CHECK(bilinear(column, {0.5, 1.0}) == close_to(45.0));
  CHECK(bilinear(column, {-2.5, -0.25}) == close_to(60.0));
  CHECK(bilinear({1, 1, {7.0}}, {-0.3, 12.9}) == close_to(7.0));
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
      INFO("texel 3 + 2 x - 5 y at x = " << x << ", y = " << y);
      REQUIRE(bilinear(ramp, {(x + 0.5) / 8, (y + 0.5) / 8}) == close_to(3.0 + 2.0 * x - 5.0 * y));
    }
  }
  std::ostringstream text;
  text << "at the left edge of 10 20 40 80 there is " << bilinear(row, {0.0, 0.5})
       << ", the mean of the first texel and the last";
  lt::measured(text.str());
}
