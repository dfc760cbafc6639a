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
using glm::ivec3;

const double pi = std::acos(-1.0);

std::string shown(dvec3 v) {
  std::ostringstream text;
  text.precision(3);
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

bool is_near(dvec3 a, dvec3 b, double tolerance) {
  return glm::distance(a, b) <= tolerance;  // false for NaN
}

bool is_finite(dvec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Degrees between two directions.
double angle(dvec3 a, dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / pi;
}

// The largest deviation from unit, perpendicular and right-handed.
double flaw(const Frame& f) {
  if (!is_finite(f.tangent) || !is_finite(f.bitangent)) return 1e9;
  return std::max({std::abs(glm::length(f.tangent) - 1), std::abs(glm::length(f.bitangent) - 1),
                   std::abs(glm::dot(f.tangent, f.bitangent)),
                   std::abs(glm::dot(f.tangent, f.normal)),
                   glm::distance(glm::cross(f.tangent, f.bitangent), f.normal)});
}

// A frame whose axes are easy to tell apart: the floor's.
const Frame floor_frame{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};

}  // namespace

TEST_CASE("a flat texel leaves the normal where it is") {
  const dvec3 flat = bumped_normal(floor_frame, {128, 128, 255});
  // Red and green of 0.502 kept as they are lean by 35 degrees to (+, +). Decoded from sRGB first,
  // 128 becomes 0.216, which is -0.568 from -1 to 1: 39 degrees to (-, -).
  const dvec3 kept = glm::normalize(dvec3(0.502, 1.0, -0.502));
  const dvec3 decoded = glm::normalize(dvec3(-0.568, 1.0, 0.568));
  const std::string seen =
      "(128, 128, 255) on the floor gave " + shown(flat) + " and should give about (0, 1, 0).";
  const dvec3 direction = is_finite(flat) ? flat / std::max(glm::length(flat), 1e-9) : flat;
  lt::diagnose(!is_near(direction, kept, 0.02), "no-remap-to-minus-one", seen);
  lt::diagnose(!is_near(direction, decoded, 0.02), "srgb-decoded-normals", seen);
  CHECK(angle(flat, {0, 1, 0}) < 0.4);  // 8 bits have no middle: 128 is 0.32 degrees off
}

TEST_CASE("red leans along the tangent and green along the bitangent") {
  // 2 * 218 / 255 - 1 = 0.7098: about 45 degrees.
  const dvec3 red = bumped_normal(floor_frame, {218, 128, 218});
  const dvec3 green = bumped_normal(floor_frame, {128, 218, 218});
  const double s = std::sqrt(0.5);
  CHECK(is_near(red, {s, s, 0}, 0.01));
  CHECK(is_near(green, {0, s, -s}, 0.01));
}

TEST_CASE("every bumped normal is unit") {
  // From -1 to 1 that is (0.5686, -0.5294, 0.4118), a vector of length 0.8793.
  const dvec3 n = bumped_normal(floor_frame, {200, 60, 180});
  const double length = glm::length(n);
  lt::diagnose(std::abs(length - 0.8793) > 1e-3, "length-not-one",
               "(200, 60, 180) gave a normal of length " + std::to_string(length) + ".");
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      const auto code = [&] { return static_cast<int>(random.uniform(0, 256)); };
      const int red = code();
      const int green = code();
      const int blue = 128 + code() / 2;
      const dvec3 bumped = bumped_normal(floor_frame, {red, green, blue});
      INFO("code " << red << ' ' << green << ' ' << blue);
      REQUIRE(std::abs(glm::length(bumped) - 1.0) < 1e-9);
      const dvec3 local = dvec3(red, blue, 255 - green) / 127.5 - 1.0;
      REQUIRE(angle(bumped, local) < 0.01);
    }
  }
}

TEST_CASE("frames are right-handed for every normal") {
  const Frame slanted = frame_around(glm::normalize(dvec3(1, 2, 3)));
  const dvec3 handed = glm::cross(slanted.tangent, slanted.bitangent);
  lt::diagnose(
      !is_near(handed, -slanted.normal, 1e-6), "left-handed-frame",
      "around " + shown(slanted.normal) + " tangent x bitangent is " + shown(handed) + ".");
  // Not only at the pole itself: next to it the sum of -1 and nearly 1 has lost its digits.
  double at_pole = 0.0;
  for (const double tiny : {0.0, 1e-12, 1e-9, 1e-8, 1e-7}) {
    const double z = -std::sqrt(1.0 - 2 * tiny * tiny);
    at_pole = std::max(at_pole, flaw(frame_around({tiny, -tiny, z})));
  }
  const double elsewhere = flaw(slanted);
  lt::diagnose(!(at_pole > 1e-6 && elsewhere < 1e-6), "breaks-at-minus-z",
               "Around (0, 0, -1), or next to it, the axes are not perpendicular unit vectors.");
  CHECK(at_pole < 1e-9);
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      const dvec3 normal = random.direction();
      INFO("normal " << shown(normal));
      const Frame frame = frame_around(normal);
      REQUIRE(frame.normal == normal);
      REQUIRE(flaw(frame) < 1e-9);
    }
  }
}

TEST_CASE("a hundred thousand frames are flawless") {
  lt::TestRandom random(1);
  double worst = 0.0;
  for (int i = 0; i < 100'000; ++i)
    worst = std::max(worst, flaw(frame_around(random.direction())));
  CHECK(worst < 1e-9);
  std::ostringstream text;
  text.precision(2);
  text << "of 100,000 frames the worst is off by " << worst << "; flat, in 8 bits, leans by "
       << angle(bumped_normal(floor_frame, {128, 128, 255}), {0, 1, 0}) << " degrees";
  lt::measured(text.str());
}
