#include "ch07_fresnel/ideal_directions.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch05_rendering_equation/uniform_hemisphere.hpp"
#include "ch07_fresnel/special_angles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;

namespace {

// A normal and a direction on its side.
struct Pair {
  vec3 h, wo;
};

Pair any_pair(Pcg32& random) {
  const vec3 h = uniform_hemisphere(random.next_vec2());
  const vec3 wo = uniform_hemisphere(random.next_vec2());
  return {h, dot(wo, h) > 0.0f ? wo : -wo};
}

}  // namespace

TEST_CASE("reflected: unit, in the plane of wo and h, at the same angle on the other side") {
  CHECK(reflected({0.6f, 0.0f, 0.8f}, {0, 0, 1}) == close_to(vec3(-0.6f, 0.0f, 0.8f), 1e-7));
  CHECK(reflected({0, 0, 1}, {0, 0, 1}) == vec3(0, 0, 1));
  Pcg32 random(1);
  for (int i = 0; i < 100'000; ++i) {
    const auto [h, wo] = any_pair(random);
    const vec3 wi = reflected(wo, h);
    REQUIRE(length(wi) == Approx(1).epsilon(1e-6));
    REQUIRE(dot(wi, h) == close_to(dot(wo, h), 1e-6));
    REQUIRE(wo + wi == close_to(2 * dot(wo, h) * h, 1e-6));  // their sum lies along h
    REQUIRE(reflected(wi, h) == close_to(wo, 3e-6));
  }
}

TEST_CASE("refracted: Snell's law holds as vectors, on either side and at every angle") {
  Pcg32 random(2);
  for (int i = 0; i < 100'000; ++i) {
    const auto [h, wo] = any_pair(random);
    const float n_here = 1.0f + 2.0f * random.next_float();
    const float n_beyond = 1.0f + 2.0f * random.next_float();
    const auto wi = refracted(wo, h, n_here / n_beyond);
    const float sine = length(cross(wo, h)) * n_here / n_beyond;
    if (!wi) REQUIRE(sine > 1.0f - 1e-6f);
    if (!wi) continue;
    REQUIRE(sine < 1.0f + 1e-6f);
    REQUIRE(length(*wi) == Approx(1).epsilon(2e-6));
    REQUIRE(dot(*wi, h) < 0.0f);
    // n (v x h) = -n' (l x h): the sines and the plane at once.
    REQUIRE(n_here * cross(wo, h) == close_to(-n_beyond * cross(*wi, h), 2e-6));
  }
}

TEST_CASE("refracted: from air to glass 60 degrees become 35.26") {
  // sin t = sin 60 / 1.5 = 1 / sqrt(3), cos t = sqrt(2/3).
  const float s = std::sqrt(3.0f) / 2.0f;
  const auto wi = refracted({s, 0.0f, 0.5f}, {0, 0, 1}, 1.0f / 1.5f);
  REQUIRE(wi);
  CHECK(*wi == close_to(vec3(-std::sqrt(1 / 3.0f), 0.0f, -std::sqrt(2 / 3.0f)), 1e-6));
}

TEST_CASE("refracted: the way back is the way") {
  Pcg32 random(3);
  for (int i = 0; i < 100'000; ++i) {
    const auto [h, wo] = any_pair(random);
    const float eta = 1.0f / (1.0f + 2.0f * random.next_float());
    const auto wi = refracted(wo, h, eta);
    REQUIRE(wi);  // into the denser medium there is always a way
    const auto back = refracted(*wi, -h, 1.0f / eta);
    // Near the horizon the cosine is the root of a small difference: an error of 1e-6 becomes one
    // of 1e-6 / cosine.
    if (dot(wo, h) < 0.01f) continue;
    REQUIRE(back);
    REQUIRE(*back == close_to(wo, 5e-6 / dot(wo, h)));
  }
}

TEST_CASE("refracted: nothing beyond the critical angle, and that is where Fresnel says 1") {
  const float critical = *critical_angle(1.5f, 1.0f);
  for (const float from : {-0.4f, -1e-3f, 1e-3f, 0.4f}) {
    const float angle = critical + from;
    const vec3 wo(std::sin(angle), 0.0f, std::cos(angle));
    CHECK(refracted(wo, {0, 0, 1}, 1.5f).has_value() == (from < 0));
  }
  Pcg32 random(4);
  for (int i = 0; i < 1'000'000; ++i) {
    const float c = random.next_float();
    const float n = 1.0f + random.next_float();
    const vec3 wo(std::sqrt(1.0f - c * c), 0.0f, c);
    const bool is_through = refracted(wo, {0, 0, 1}, n / 1.0f).has_value();
    if ((fresnel_dielectric(c, n, 1.0f) < 1.0f) && !is_through) REQUIRE(false);
  }
}

TEST_CASE("refracted: with equal indices it goes straight on") {
  Pcg32 random(5);
  for (int i = 0; i < 1000; ++i) {
    const auto [h, wo] = any_pair(random);
    const auto wi = refracted(wo, h, 1.0f);
    REQUIRE(wi);
    REQUIRE(*wi == close_to(-wo, 1e-6));
  }
}
