#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::bumped_normal;
using exercise::Frame;
using exercise::frame_around;
using glm::dvec3;
using lt::close_to;

const double pi = std::acos(-1.0);

// To three decimals: 5e-8 is 0, and not -0.
double rounded(double x) {
  return std::isnan(x) ? std::abs(x) : std::round(1000 * x) / 1000 + 0.0;
}

std::string shown(dvec3 v) {
  std::ostringstream text;
  text << '(' << rounded(v.x) << ", " << rounded(v.y) << ", " << rounded(v.z) << ')';
  return text.str();
}

std::string shown(const Frame& f) {
  return "Around " + shown(f.normal) + " the tangent is " + shown(f.tangent) +
         " and the bitangent " + shown(f.bitangent);
}

// Degrees between two directions.
double angle(dvec3 a, dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / pi;
}

// How far the axes are from unit, perpendicular and in the right order; huge if one is NaN.
double flaw(const Frame& f) {
  const double sum = std::abs(glm::length(f.tangent) - 1) + std::abs(glm::length(f.bitangent) - 1) +
                     std::abs(glm::dot(f.tangent, f.bitangent)) +
                     glm::distance(glm::cross(f.tangent, f.bitangent), f.normal);
  return std::isfinite(sum) ? sum : 1e9;
}

// The worst of the frames around an axis of the world and next to it, where a sum of -1 and nearly
// 1 has lost its digits.
Frame worst_frame_at(dvec3 axis) {
  Frame worst = frame_around(axis);
  for (const double tiny : {1e-12, 1e-9, 1e-8, 1e-7, 1e-5}) {
    const Frame next = frame_around(glm::normalize(axis + tiny * dvec3(axis.y, axis.z, axis.x)));
    if (flaw(next) > flaw(worst)) worst = next;
  }
  return worst;
}

// A frame whose axes are easy to tell apart: the floor's.
const Frame floor_frame{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};

// What a code means on the floor: 127.5 would be the middle. Green leans to -z.
dvec3 meant_by(glm::ivec3 code) {
  return glm::normalize(dvec3(code.x, code.z, 255 - code.y) / 127.5 - 1.0);
}

// The same with 128 for the middle.
dvec3 with_middle_128(glm::ivec3 code) {
  return glm::normalize(dvec3(code.x, code.z, 256 - code.y) / 128.0 - 1.0);
}

bool has_nan(dvec3 v) {
  return std::isnan(v.x + v.y + v.z);
}

}  // namespace

TEST_CASE("every code counts, and the middle is 127.5") {
  const dvec3 bumped = bumped_normal(floor_frame, {200, 60, 180});
  const dvec3 other = bumped_normal(floor_frame, {100, 150, 130});
  const dvec3 with_255 = bumped_normal(floor_frame, {255, 60, 180});
  // Whole numbers make both (0, 0, 0), which is (-1, -1, -1) from -1 to 1, or NaN once it has been
  // made unit without that.
  const bool is_same = bumped == close_to(other) || (has_nan(bumped) && has_nan(other));
  lt::diagnose(!(is_same && !has_nan(with_255) && !(with_255 == close_to(bumped))),
               "integers-divide-to-0-or-1",
               "(200, 60, 180) and (100, 150, 130) on the floor both gave " + shown(bumped) + ".");
  // 256 makes 128 the middle: (255, 128, 128) is then red alone, without the 1 / 255 of the others.
  const dvec3 reddest = bumped_normal(floor_frame, {255, 128, 128});
  const bool is_middle_128 = glm::normalize(bumped) == close_to(with_middle_128({200, 60, 180})) &&
                             glm::normalize(reddest) == close_to(dvec3(1, 0, 0));
  lt::diagnose(!is_middle_128, "middle-at-128",
               "(200, 60, 180) on the floor gave " + shown(bumped) + " and should give " +
                   shown(meant_by({200, 60, 180})) + ".");
}

TEST_CASE("a flat texel leaves the normal where it is") {
  const dvec3 flat = bumped_normal(floor_frame, {128, 128, 255});
  const std::string seen =
      "(128, 128, 255) on the floor gave " + shown(flat) + " and should give about (0, 1, 0).";
  // Red and green of 128 / 255 = 0.502, kept as they are, lean by 35 degrees to (+, +). Decoded
  // from sRGB first, 128 becomes 0.216, which is -0.568 from -1 to 1: 39 degrees to (-, -).
  const bool is_kept = angle(flat, {0.502, 1.0, -0.502}) < 1.0;
  const bool is_decoded = angle(flat, {-0.568, 1.0, 0.568}) < 1.0;
  lt::diagnose(!is_kept, "no-remap-to-minus-one", seen);
  lt::diagnose(!is_decoded, "srgb-decoded-normals", seen);
  INFO(seen);
  CHECK(angle(flat, {0, 1, 0}) < 0.4);  // 8 bits have no middle: 128 is 0.32 degrees off
}

TEST_CASE("red leans along the tangent and green along the bitangent") {
  // 2 * 218 / 255 - 1 = 0.7098: about 45 degrees.
  const double s = std::sqrt(0.5);
  const dvec3 green = bumped_normal(floor_frame, {128, 218, 218});
  lt::diagnose(angle(green, {0, s, s}) > 1.0, "green-upside-down",
               "(128, 218, 218) on the floor gave " + shown(green) +
                   " and should give about (0, 0.707, -0.707).");
  CHECK(bumped_normal(floor_frame, {128, 218, 218}) == close_to(dvec3(0, s, -s), 0.01));
  CHECK(bumped_normal(floor_frame, {218, 128, 218}) == close_to(dvec3(s, s, 0), 0.01));
}

TEST_CASE("a bumped normal is unit, whatever the codes") {
  // From -1 to 1 that is (0.569, -0.529, 0.412), a vector of length 0.879.
  const dvec3 bumped = bumped_normal(floor_frame, {200, 60, 180});
  const double length = glm::length(bumped);
  const bool is_right_way = angle(bumped, meant_by({200, 60, 180})) < 0.1;
  lt::diagnose(!is_right_way || length == close_to(1.0), "length-not-one",
               "(200, 60, 180) gave a normal of length " + std::to_string(length) + ".");
  CHECK(glm::length(bumped_normal(floor_frame, {200, 60, 180})) == close_to(1.0));
}

TEST_CASE("a bumped normal points where its codes say") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      const int red = static_cast<int>(random.uniform(0, 256));
      const int green = static_cast<int>(random.uniform(0, 256));
      // Blue below 128 would look into the wall; chapter 3 lets none come nearer to it than 129.
      const int blue = static_cast<int>(random.uniform(129, 256));
      const dvec3 bumped = bumped_normal(floor_frame, {red, green, blue});
      INFO("code (" << red << ", " << green << ", " << blue << ") on the floor");
      REQUIRE(bumped == close_to(meant_by({red, green, blue})));
    }
  }
}

TEST_CASE("a frame has three perpendicular unit vectors, and tangent x bitangent is the normal") {
  const Frame slanted = frame_around(glm::normalize(dvec3(1, 2, 3)));
  const dvec3 third = glm::cross(slanted.tangent, slanted.bitangent);
  lt::diagnose(!(third == close_to(-slanted.normal)), "mirrored-frame",
               "Around " + shown(slanted.normal) + " tangent x bitangent is " + shown(third) + ".");
  for (const dvec3 axis : {dvec3(0, 0, -1), dvec3(0, 0, 1), dvec3(0, -1, 0), dvec3(0, 1, 0),
                           dvec3(-1, 0, 0), dvec3(1, 0, 0)}) {
    const Frame worst = worst_frame_at(axis);
    lt::diagnose(flaw(worst) < 1e-6 || flaw(slanted) > 1e-6, "breaks-at-an-axis",
                 shown(worst) + ".");
  }
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      const dvec3 normal = random.direction();
      const Frame frame = frame_around(normal);
      INFO(shown(frame));
      REQUIRE(frame.normal == close_to(normal));
      REQUIRE(glm::length(frame.tangent) == close_to(1.0));
      REQUIRE(glm::length(frame.bitangent) == close_to(1.0));
      REQUIRE(glm::dot(frame.tangent, frame.bitangent) == close_to(0.0));
      REQUIRE(glm::cross(frame.tangent, frame.bitangent) == close_to(normal));
    }
  }
}

TEST_CASE("a hundred thousand frames hold") {
  lt::TestRandom random(1);
  double worst = 0.0;
  for (int i = 0; i < 100'000; ++i)
    worst = std::max(worst, flaw(frame_around(random.direction())));
  CHECK(worst < 1e-6);
  std::ostringstream text;
  text.precision(2);
  text << "of 100,000 frames the worst is off by " << worst << "; flat, in 8 bits, leans by "
       << angle(bumped_normal(floor_frame, {128, 128, 255}), {0, 1, 0}) << " degrees";
  lt::measured(text.str());
}
