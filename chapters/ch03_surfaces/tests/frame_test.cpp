// Frames are what they promise for every normal there is.
#include "ch03_surfaces/frame.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ch03_surfaces/tests/random_input.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// How far a frame is from three perpendicular unit vectors with tangent x bitangent = normal.
// NaN counts as infinitely far.
float flaw(const Frame& frame) {
  const vec3 handedness = cross(frame.tangent, frame.bitangent) - frame.normal;
  float worst = length(handedness);
  for (const float error : {length(frame.tangent) - 1.0f, length(frame.bitangent) - 1.0f,
                            length(frame.normal) - 1.0f, dot(frame.tangent, frame.bitangent),
                            dot(frame.tangent, frame.normal), dot(frame.bitangent, frame.normal)})
    worst = std::max(worst, std::isnan(error) ? infinity : std::abs(error));
  return std::isnan(worst) ? infinity : worst;
}

// The axes, and what lies next to them: the places where formulas divide by nearly zero.
std::vector<vec3> difficult_normals() {
  std::vector<vec3> normals;
  for (const float tiny : {0.0f, -0.0f, 1e-30f, 1e-12f, 1e-7f, 1e-6f, 1e-4f, 1e-3f})
    for (const float sign : {1.0f, -1.0f}) {
      const float nearly_1 = std::sqrt(1.0f - 2.0f * tiny * tiny);  // 1, 1 - 2^-24, ...
      normals.push_back({tiny, -tiny, sign * nearly_1});
      normals.push_back({tiny, sign * nearly_1, -tiny});
      normals.push_back({sign * nearly_1, -tiny, tiny});
    }
  return normals;
}

}  // namespace

TEST_CASE("frames: around a million normals, axes are unit, perpendicular and right-handed") {
  RandomInput random(1);
  float worst = 0.0f;
  for (int i = 0; i < 1'000'000; ++i)
    worst = std::max(worst, flaw(frame_around(random.direction())));
  CHECK(worst < 1e-6f);  // eight times the spacing of floats near 1
}

TEST_CASE("frames: the normals along and next to the axes are no exception") {
  for (const vec3 normal : difficult_normals()) {
    CAPTURE(normal);
    CHECK(flaw(frame_around(normal)) < 1e-6f);
    CHECK(flaw(frame_along(normal, {0.3f, 0.4f, 0.5f})) < 1e-6f);
    CHECK(frame_around(normal).normal == normal);
  }
}

TEST_CASE("frames: along a tangent, axes are unit, perpendicular and right-handed") {
  RandomInput random(2);
  float worst = 0.0f;
  for (int i = 0; i < 100'000; ++i) {
    const vec3 normal = random.direction();
    const float size = std::exp(random.uniform(-9.0f, 9.0f));
    worst = std::max(worst, flaw(frame_along(normal, size * random.direction())));
  }
  // Tangents within 0.6 degrees of the normal occur here, one in 20,000: subtracting what they have
  // along the normal cancels two digits.
  CHECK(worst < 1e-4f);
}

TEST_CASE("frames: a tangent that is perpendicular already is kept, but made unit") {
  const Frame frame = frame_along({0.0f, 0.0f, -1.0f}, {3.0f, 4.0f, 0.0f});
  CHECK(distance(frame.tangent, vec3(0.6f, 0.8f, 0.0f)) < 1e-6f);
}

TEST_CASE("frames: the tangent is the nearest one to the tangent asked for") {
  // Of (1, 1, 0), what is perpendicular to (0, 1, 0) is (1, 0, 0).
  const Frame frame = frame_along({0.0f, 1.0f, 0.0f}, {1.0f, 1.0f, 0.0f});
  CHECK(distance(frame.tangent, vec3(1.0f, 0.0f, 0.0f)) < 1e-6f);
  CHECK(distance(frame.bitangent, vec3(0.0f, 0.0f, -1.0f)) < 1e-6f);
}

TEST_CASE("frames: without a usable tangent there is a frame all the same") {
  RandomInput random(3);
  for (int i = 0; i < 1000; ++i) {
    const vec3 normal = random.direction();
    CHECK(flaw(frame_along(normal, vec3(0.0f))) < 1e-6f);
    CHECK(flaw(frame_along(normal, normal)) < 1e-6f);
    CHECK(flaw(frame_along(normal, -3.0f * normal)) < 1e-6f);
  }
}

TEST_CASE("frames: to local coordinates and back is where it was") {
  RandomInput random(4);
  for (int i = 0; i < 1000; ++i) {
    const Frame frame = frame_around(random.direction());
    const vec3 v = 5.0f * random.direction();
    CHECK(distance(frame.to_world(frame.to_local(v)), v) < 1e-5f);
    CHECK(distance(frame.to_local(frame.normal), vec3(0.0f, 0.0f, 1.0f)) < 1e-6f);
    CHECK(distance(frame.to_world({1.0f, 0.0f, 0.0f}), frame.tangent) == 0.0f);
  }
}

TEST_CASE("frames: seen from behind the normal is turned and the handedness kept") {
  RandomInput random(5);
  for (int i = 0; i < 1000; ++i) {
    const Frame front = frame_around(random.direction());
    const Frame back = seen_from_behind(front);
    CHECK(back.normal == -front.normal);
    CHECK(flaw(back) < 1e-6f);
  }
}
