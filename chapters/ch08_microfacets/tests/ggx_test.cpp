#include "ch08_microfacets/ggx.hpp"

#include "ch08_microfacets/roughness.hpp"
#include "ch08_microfacets/tests/oracles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

TEST_CASE("ggx: straight up D is 1 / (pi alpha^2)") {
  CHECK(Ggx{1.0f}.d({0, 0, 1}) == close_to(1 / pi_, 1e-7));
  CHECK(Ggx{0.3f}.d({0, 0, 1}) == close_to(3.5368, 1e-4));   // alpha = roughness 0.3
  CHECK(Ggx{0.09f}.d({0, 0, 1}) == close_to(39.298, 1e-3));  // alpha = roughness squared
}

TEST_CASE("ggx: D is the formula with tangents, evaluated in double") {
  for (const float alpha : {1e-4f, 1e-3f, 0.02f, 0.1f, 0.5f, 1.0f})
    for (const double degrees : {0.0, 0.005, 0.1, 1.0, 10.0, 30.0, 60.0, 89.0, 89.99}) {
      const double theta = degrees * pi_ / 180;
      const vec3 h(std::sin(theta) * 0.6, std::sin(theta) * 0.8, std::cos(theta));
      CHECK(Ggx{alpha}.d(h) == Approx(d_by_angle(alpha, theta)).epsilon(2e-6));
    }
}

TEST_CASE("ggx: the facets' shadows at noon cover the ground once") {
  // The integral of D cos is 1, for every width.
  for (const float alpha : {1e-4f, 1e-3f, 0.02f, 0.05f, 0.1f, 0.3f, 0.6f, 1.0f}) {
    const Ggx ggx{alpha};
    CHECK(integrate_facets(alpha, 1000, [&](vec3 h) { return double{ggx.d(h)} * h.z; }) ==
          close_to(1.0, 2e-5));
  }
}

TEST_CASE("ggx: the facets' area is more than the ground's") {
  // The integral of D: 1.0301, 1.1768, 1.4944 and 2, computed independently (errata of eq. 6).
  const std::pair<float, double> areas[] = {{0.1f, 1.0301}, {0.3f, 1.1768}, {0.6f, 1.4944}, {1, 2}};
  for (const auto& [alpha, area] : areas) {
    const Ggx ggx{alpha};
    CHECK(integrate_facets(alpha, 1000, [&](vec3 h) { return double{ggx.d(h)}; }) ==
          close_to(area, 1e-4));
  }
}

TEST_CASE("ggx: half of the facets' shadows belong to slopes up to alpha") {
  // D cos has the distribution t^2 / (alpha^2 + t^2) in t = tan(theta): 1/2 at t = alpha, 9/10 at
  // t = 3 alpha.
  for (const float alpha : {0.02f, 0.1f, 0.3f, 1.0f}) {
    const auto share_below = [&](double slope) {
      return integrate_facets(alpha, 2000, [&](vec3 h) {
        const bool is_flat = std::hypot(h.x, h.y) < slope * h.z;
        return is_flat ? double{Ggx{alpha}.d(h)} * h.z : 0.0;
      });
    };
    CHECK(share_below(double{alpha}) == close_to(0.5, 1e-3));
    CHECK(share_below(3.0 * double{alpha}) == close_to(0.9, 1e-3));
  }
}

TEST_CASE("ggx: no facet faces down, and turning the surface changes nothing") {
  CHECK(Ggx{0.3f}.d({0, 0, -1}) == 0.0f);
  CHECK(Ggx{0.3f}.d({1, 0, 0}) == 0.0f);
  CHECK(Ggx{0.3f}.d(vec3(0.0f)) == 0.0f);
  const float east = Ggx{0.3f}.d({0.6f, 0.0f, 0.8f});
  CHECK(Ggx{0.3f}.d({0.0f, -0.6f, 0.8f}) == east);
  CHECK(Ggx{0.3f}.d({-0.36f, 0.48f, 0.8f}) == Approx(east).epsilon(1e-6));
}

TEST_CASE("ggx: lambda is 0 straight above, infinite at the horizon and the same from below") {
  for (const float alpha : {1e-4f, 0.3f, 1.0f}) {
    CHECK(Ggx{alpha}.lambda({0, 0, 1}) == 0.0f);
    CHECK(Ggx{alpha}.lambda({1, 0, 0}) == infinity);
    CHECK(Ggx{alpha}.lambda({0.6f, 0, -0.8f}) == Ggx{alpha}.lambda({0.6f, 0, 0.8f}));
  }
  CHECK(Ggx{1.0f}.lambda(at_degrees(60)) == close_to(0.5, 1e-6));  // (1 / cos(60) - 1) / 2
}

TEST_CASE("roughness: the thesis' alpha is the roughness, others' its square, none is 0") {
  CHECK(alpha_of(0.3f) == 0.3f);
  CHECK(alpha_of(1.0f) == 1.0f);
  CHECK(alpha_of(0.0f) == smallest_alpha);
  CHECK(alpha_of_square(0.5f) == 0.25f);
  CHECK(alpha_of_square(1.0f) == 1.0f);
  CHECK(alpha_of_square(0.0f) == smallest_alpha);
}
