#include "ch08_microfacets/half_vector.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch05_rendering_equation/uniform_hemisphere.hpp"
#include "ch07_fresnel/ideal_directions.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;

TEST_CASE("half vector: of a direction and itself it is that direction") {
  const vec3 w(0.6f, 0.0f, 0.8f);
  CHECK(half_vector(w, w) == close_to(w, 1e-7));
}

TEST_CASE("half vector: a facet that faces it mirrors the one direction into the other") {
  Pcg32 random(1);
  for (int i = 0; i < 10'000; ++i) {
    const vec3 wo = uniform_hemisphere(random.next_vec2());
    const vec3 wi = uniform_hemisphere(random.next_vec2());
    const vec3 h = half_vector(wo, wi);
    REQUIRE(length(h) == close_to(1.0, 1e-6));
    REQUIRE(half_vector(wi, wo) == h);
    REQUIRE(dot(wo, h) == close_to(dot(wi, h), 1e-5));
    REQUIRE(dot(wo, h) > 0.0f);
    REQUIRE(reflected(wo, h) == close_to(wi, 2e-6));
  }
}

TEST_CASE("half vector: opposite directions have none, and no NaN either") {
  CHECK(half_vector({0, 0, 1}, {0, 0, -1}) == vec3(0.0f));
  CHECK(half_vector({1, 0, 0}, {-1, 0, 0}) == vec3(0.0f));
  CHECK(half_vector({1, 0, 1e-25f}, {-1, 0, 1e-25f}) == vec3(0.0f));
  CHECK(half_vector({1, 0, 1e-15f}, {-1, 0, 1e-15f}) == close_to(vec3(0, 0, 1), 1e-6));
}

TEST_CASE("half vector: a facet that turns by one degree turns the light by two") {
  // Straight on, so that four times the solid angle of the facets is that of the light: the 4 in
  // the reflection's formula. At 60 degrees it is 4 cos(60) = 2 (Walter et al. 2007, eq. 14).
  for (const float degrees : {0.0f, 60.0f}) {
    const vec3 h(0, 0, 1);
    const vec3 wo(std::sin(radians(degrees)), 0, std::cos(radians(degrees)));
    const float step = 1e-2f;
    const auto turned = [&](float x, float y) {
      return normalize(vec3(std::sin(x), std::sin(y), std::cos(x) * std::cos(y)));
    };
    const auto wi = [&](float x, float y) { return reflected(wo, turned(x, y)); };
    const vec3 along_x = (wi(step, 0) - wi(-step, 0)) / (2 * step);
    const vec3 along_y = (wi(0, step) - wi(0, -step)) / (2 * step);
    CHECK(length(cross(along_x, along_y)) == close_to(4 * dot(wo, h), 2e-3));
  }
}
