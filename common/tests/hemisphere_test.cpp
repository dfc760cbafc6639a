#include "common/testkit/hemisphere.hpp"

#include <limits>

using namespace lt;

namespace {

// Height and turn both even: the uniform distribution (Archimedes).
glm::dvec3 at_height(double z, double turns) {
  const double radius = std::sqrt(1 - z * z);
  const double phi = 2 * std::numbers::pi * turns;
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}
glm::dvec3 uniform(glm::dvec2 u) {
  return at_height(u.x, u.y);
}
glm::dvec3 cosine(glm::dvec2 u) {
  return at_height(std::sqrt(u.x), u.y);
}
glm::dvec3 linear_theta(glm::dvec2 u) {
  return at_height(std::cos(std::numbers::pi / 2 * u.x), u.y);
}
glm::dvec3 in_degrees(glm::dvec2 u) {
  return at_height(u.x, 360 * u.y / (2 * std::numbers::pi));
}
glm::dvec3 half_turn(glm::dvec2 u) {
  return at_height(u.x, u.y / 2);
}

}  // namespace

TEST_CASE("hemisphere: each way to unfold spreads its own distribution evenly - and no other") {
  const HemisphereSampler samplers[] = {uniform, cosine, linear_theta};
  const Unfold ways[] = {unfold_uniform, unfold_cosine, unfold_linear_theta};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      INFO("sampler " << i << " unfolded by way " << j);
      CHECK(is_spread_evenly(draw_directions(samplers[i], 1), ways[j]) == (i == j));
    }
}

TEST_CASE("hemisphere: a turn goes from x to y and never below 0") {
  CHECK(turn({1, 0, 0}) == 0);
  CHECK(turn({0, 1, 0}) == 0.25);
  CHECK(turn({0, -1, 0}) == 0.75);
}

TEST_CASE("hemisphere: an angle in degrees passes every count and is told") {
  CHECK(is_spread_evenly(draw_directions(in_degrees, 1), unfold_uniform));
  CHECK(is_turned_in_degrees(in_degrees));
  CHECK_FALSE(is_turned_in_degrees(uniform));
}

TEST_CASE("hemisphere: what is seen of half a turn is a cell with nothing and one with too much") {
  const std::string text = text_of_unevenness(draw_directions(half_turn, 1), unfold_uniform,
                                              [](double height) { return height; });
  INFO(text);
  // Turns of 0 to 1/2 leave out the last 8 of 16 columns; the first empty cell is row 0, column 8.
  CHECK(text.find("(z 0 to 0.0625, phi 180 to 202 degrees) holds 0,") != std::string::npos);
  CHECK(text.find("about 390 directions") != std::string::npos);  // 100,000 / 256
}

TEST_CASE("hemisphere: the rim of the square is among its places") {
  const std::vector<glm::dvec2> places = places_on_square();
  const glm::dvec2 corner(0.0, 1 - 0x1p-53);
  CHECK(std::count(places.begin(), places.end(), corner) == 1);
  CHECK(places.size() == 26 * 26);
}

TEST_CASE("seen: nan has no sign and the largest u their names") {
  CHECK(text_of(-std::numeric_limits<double>::quiet_NaN()) == "nan");
  CHECK(text_of(1.0 / 3) == "0.333333");
  CHECK(text_of(1.0 / 3, 3) == "0.333");
  CHECK(text_of_u(1 - 0x1p-53) == "1 - 2^-53");
  CHECK(text_of_u(1 - 0x1p-24) == "1 - 2^-24");
  CHECK(text_of_u(0.25) == "0.25");
}
