#include "ch08_microfacets/masking.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch05_rendering_equation/uniform_hemisphere.hpp"
#include "ch08_microfacets/tests/oracles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const vec3 up(0, 0, 1);

}  // namespace

TEST_CASE("masking: what one sees of all facets covers what one sees of the ground") {
  // The integral of G1 D (w h) is the cosine of w, for 9 angles and 5 widths: this is what makes
  // Smith's G1 the only one for its D.
  for (const float alpha : five_alphas)
    for (const float degrees : nine_angles) {
      const Ggx ggx{alpha};
      const vec3 w = at_degrees(degrees);
      const double seen = integrate_facets(alpha, 600, [&](vec3 h) {
        return double{g1(ggx, w, h)} * ggx.d(h) * std::max(0.0f, dot(w, h));
      });
      CHECK(seen / w.z == close_to(1.0, 5e-5));
    }
}

TEST_CASE("masking: G1 is the form without tangents, evaluated in double") {
  for (const float alpha : {1e-4f, 0.02f, 0.3f, 1.0f})
    for (const float mu : {1e-6f, 1e-3f, 0.1f, 0.5f, 0.9f, 1.0f}) {
      const vec3 w(std::sqrt((1 - mu) * (1 + mu)), 0, mu);
      CHECK(g1(Ggx{alpha}, w, up) == Approx(g1_by_cosine(alpha, mu)).epsilon(1e-5));
    }
}

TEST_CASE("masking: everything is seen from straight above, nothing from the horizon") {
  for (const float alpha : {1e-4f, 0.3f, 1.0f}) {
    const Ggx ggx{alpha};
    CHECK(g1(ggx, up, up) == 1.0f);
    CHECK(g1(ggx, {1, 0, 0}, {1, 0, 0}) == 0.0f);
    CHECK(g1(ggx, {1, 0, 1e-30f}, {1, 0, 0}) == 0.0f);
    for (const auto g2 : {g2_separable, g2_correlated}) {
      CHECK(g2(ggx, up, up) == 1.0f);
      CHECK(g2(ggx, up, {1, 0, 0}) == 0.0f);
      CHECK(g2(ggx, {1, 0, 0}, {1, 0, 0}) == 0.0f);
      CHECK(g2(ggx, {1, 0, 1e-30f}, {-1, 0, 1e-30f}) == 0.0f);
    }
  }
}

TEST_CASE("masking: nobody sees a facet's back") {
  const Ggx ggx{0.5f};
  CHECK(g1(ggx, at_degrees(80), at_degrees(-20)) == 0.0f);
  CHECK(g1(ggx, at_degrees(80), at_degrees(-5)) > 0.0f);
  CHECK(g1(ggx, -at_degrees(30), up) == g1(ggx, at_degrees(30), up));  // its underside
  CHECK(g1(ggx, -at_degrees(30), at_degrees(80)) == g1(ggx, at_degrees(30), at_degrees(80)));
  CHECK(g1(ggx, -at_degrees(80), at_degrees(-20)) == 0.0f);
}

TEST_CASE("masking: seen and lit is at most seen, at most lit, and at least seen times lit") {
  Pcg32 random(1);
  for (int i = 0; i < 100'000; ++i) {
    const Ggx ggx{std::max(1e-4f, random.next_float())};
    const vec3 wo = uniform_hemisphere(random.next_vec2());
    const vec3 wi = uniform_hemisphere(random.next_vec2());
    const float separable = g2_separable(ggx, wo, wi);
    const float correlated = g2_correlated(ggx, wo, wi);
    const float least = std::min(g1(ggx, wo, up), g1(ggx, wi, up));
    REQUIRE(separable >= 0.0f);
    REQUIRE(separable <= correlated * (1 + 1e-6f));
    REQUIRE(correlated <= least * (1 + 1e-6f));
    REQUIRE(g2_separable(ggx, wi, wo) == separable);
    REQUIRE(g2_correlated(ggx, wi, wo) == Approx(correlated).epsilon(1e-6));
  }
}

TEST_CASE("masking: both forms are those of the papers, evaluated in double") {
  for (const float alpha : {1e-4f, 0.02f, 0.3f, 1.0f})
    for (const float mu_o : {1e-3f, 0.1f, 0.5f, 1.0f})
      for (const float mu_i : {1e-3f, 0.2f, 0.9f}) {
        const Ggx ggx{alpha};
        const vec3 wo(std::sqrt((1 - mu_o) * (1 + mu_o)), 0, mu_o);
        const vec3 wi(0, std::sqrt((1 - mu_i) * (1 + mu_i)), mu_i);
        const double product = g1_by_cosine(alpha, mu_o) * g1_by_cosine(alpha, mu_i);
        CHECK(g2_separable(ggx, wo, wi) == Approx(product).epsilon(1e-5));
        CHECK(g2_correlated(ggx, wo, wi) == Approx(g2_by_cosines(alpha, mu_o, mu_i)).epsilon(1e-5));
      }
}

TEST_CASE("masking: directions on two sides have nothing to do with reflection") {
  CHECK(g2_separable(Ggx{0.5f}, up, -up) == 0.0f);
  CHECK(g2_correlated(Ggx{0.5f}, up, -up) == 0.0f);
}
