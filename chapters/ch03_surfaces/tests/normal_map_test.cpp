// Normal maps: what texels say, and what shading may believe of it.
#include "ch03_surfaces/normal_map.hpp"

#include <cmath>

#include "ch03_surfaces/tests/random_input.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

constexpr vec3 flat(0.5f, 0.5f, 1.0f);

// The north wall as seen from inside the room: right is +x, down is -y, out is -z.
const Frame north{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};

}  // namespace

TEST_CASE("normal maps: a flat texel changes nothing") {
  CHECK(decode_normal(flat) == vec3(0, 0, 1));
  RandomInput random(1);
  for (int i = 0; i < 1000; ++i) {
    const Frame frame = frame_around(random.direction());
    vec3 wo = random.direction();
    if (dot(wo, frame.normal) < 0.0f) wo = -wo;
    const Frame same = bumped(frame, flat, wo);
    CHECK(distance(same.normal, frame.normal) < 1e-6f);
    CHECK(distance(same.tangent, frame.tangent) < 1e-6f);
  }
}

TEST_CASE("normal maps: the nearest that 8 bits come to flat is 0.32 degrees off") {
  // Code 128 says 128 / 255 * 2 - 1 = 1 / 255: atan(sqrt(2) / 255) = 0.3178 degrees.
  const vec3 n = decode_normal(vec3(128.0f, 128.0f, 255.0f) / 255.0f);
  CHECK(std::acos(n.z) * 180.0f / pi == Approx(0.3178).epsilon(0.01));
}

TEST_CASE("normal maps: red leans right, green leans down") {
  const float s = std::sqrt(0.5f);
  const vec3 right = (vec3(s, 0, s) + 1.0f) / 2.0f;
  const vec3 down = (vec3(0, s, s) + 1.0f) / 2.0f;
  const vec3 wo(0, 0, -1);
  CHECK(distance(bumped(north, right, wo).normal, vec3(s, 0, -s)) < 1e-6f);
  CHECK(distance(bumped(north, down, wo).normal, vec3(0, -s, -s)) < 1e-6f);
}

TEST_CASE("normal maps: every texel gives a unit normal in front of the surface") {
  RandomInput random(2);
  for (int i = 0; i < 10'000; ++i) {
    const vec3 n =
        decode_normal({random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)});
    REQUIRE(length(n) == Approx(1.0).margin(1e-6));
    REQUIRE(n.z > 0.0f);
  }
  for (const vec3 texel :
       {vec3(0.0f), vec3(0.5f), vec3(0.5f, 0.5f, 0.0f), vec3(1.0f, 0.5f, 0.5f)}) {
    CHECK(length(decode_normal(texel)) == Approx(1.0).margin(1e-6));
    CHECK(decode_normal(texel).z > 0.0f);
  }
}

TEST_CASE("normal maps: the shading normal is unit and faces the viewer") {
  RandomInput random(3);
  for (int i = 0; i < 100'000; ++i) {
    const vec3 geometric = random.direction();
    vec3 normal = random.direction();
    vec3 wo = random.direction();
    if (dot(normal, geometric) < 0.0f) normal = -normal;
    if (dot(wo, geometric) < 0.0f) wo = -wo;
    const vec3 kept = keep_visible(normal, geometric, wo);
    REQUIRE(length(kept) == Approx(1.0).margin(1e-6));
    REQUIRE(dot(kept, wo) > -1e-6f);
    REQUIRE(dot(kept, geometric) > -1e-6f);
    if (dot(normal, wo) > 0.01f) REQUIRE(kept == normal);  // nothing to do, nothing done
  }
}

TEST_CASE("normal maps: a viewer along the surface does not bend a flat normal") {
  const vec3 grazing = normalize(vec3(1.0f, 0.0f, -1e-4f));
  CHECK(keep_visible({0, 0, -1}, {0, 0, -1}, grazing) == vec3(0, 0, -1));
}

TEST_CASE("normal maps: bumped frames are right-handed") {
  RandomInput random(4);
  for (int i = 0; i < 10'000; ++i) {
    const Frame frame = frame_around(random.direction());
    vec3 wo = random.direction();
    if (dot(wo, frame.normal) < 0.0f) wo = -wo;
    const vec3 texel(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0.5f, 1));
    const Frame bump = bumped(frame, texel, wo);
    REQUIRE(distance(cross(bump.tangent, bump.bitangent), bump.normal) < 1e-4f);
    REQUIRE(dot(bump.tangent, bump.normal) == Approx(0.0).margin(1e-4));
  }
}
