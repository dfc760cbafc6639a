// What each mistake does, in numbers; and which test would not have seen it.
#include "ch08_microfacets/mistakes.hpp"

#include "ch08_microfacets/albedo.hpp"
#include "ch08_microfacets/any_brdf.hpp"
#include "ch08_microfacets/tests/oracles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

AnyBrdf white(const std::string& wrong, float alpha) {
  return brdf_named({"correlated", wrong}, Ggx{alpha}, PerfectMirror{});
}
AnyBrdf right(float alpha) {
  return white("none", alpha);
}

double white_albedo(const std::string& wrong, float alpha, vec3 wo) {
  return albedo(white(wrong, alpha), alpha, wo, 600);
}

const vec3 up(0, 0, 1);

}  // namespace

TEST_CASE("mistakes: alpha squared twice still has shadows that cover the ground once") {
  // Any width passes that test, so it sees nothing. The half of the facets up to slope alpha does.
  const float alpha = 0.4f;
  const Ggx wrong{alpha * alpha};
  CHECK(integrate_facets(alpha, 1000, [&](vec3 h) { return double{wrong.d(h)} * h.z; }) ==
        close_to(1.0, 1e-4));
  const double flat = integrate_facets(alpha, 1000, [&](vec3 h) {
    return std::hypot(h.x, h.y) < alpha * h.z ? double{wrong.d(h)} * h.z : 0.0;
  });
  CHECK(flat == close_to(1 / 1.16, 2e-3));  // t^2 / (alpha^4 + t^2) at t = alpha = 0.4
}

TEST_CASE("mistakes: alpha squared twice, what one sees no longer covers the ground") {
  // G1 belongs to another D: the integral of G1 D (w h) is G1(alpha) / G1(alpha^2) of the cosine.
  const float alpha = 0.4f;
  const vec3 w = at_degrees(75);
  const double seen = integrate_facets(alpha, 1000, [&](vec3 h) {
    return double{g1(Ggx{alpha}, w, h)} * Ggx{alpha * alpha}.d(h) * std::max(0.0f, dot(w, h));
  });
  const double expected = g1_by_cosine(0.4, w.z) / g1_by_cosine(0.16, w.z);
  CHECK(seen / w.z == close_to(expected, 1e-3));
  CHECK(expected < 0.81);
}

TEST_CASE("mistakes: squared twice, only alpha 1 is right and 0.1 is a hundred times too bright") {
  CHECK(white("squared", 1.0f)(up, up) == right(1.0f)(up, up));
  CHECK(white("squared", 0.1f)(up, up).g / right(0.1f)(up, up).g == Approx(100.0).epsilon(1e-5));
}

TEST_CASE("mistakes: a sum for a half vector is 16 times too dim straight on, and glows at rims") {
  // D of a vector s times as long is D / s^4, s = 2 cos of light and facet: 2 straight on, 2 / 10
  // where wo and wi lie 84.26 degrees (cosine 0.1) to both sides.
  CHECK(white("half", 0.3f)(up, up).g / right(0.3f)(up, up).g == Approx(1.0 / 16).epsilon(1e-5));
  const vec3 left = at_cosine(0.1f);
  const vec3 across(-left.x, 0.0f, left.z);
  CHECK(white("half", 0.3f)(left, across).g / right(0.3f)(left, across).g ==
        Approx(625.0).epsilon(1e-4));
}

TEST_CASE("mistakes: a sum for a half vector is reciprocal, and creates light") {
  const AnyBrdf wrong = white("half", 0.3f);
  CHECK(wrong(at_degrees(20), at_degrees(-60)).g ==
        Approx(wrong(at_degrees(-60), at_degrees(20)).g).epsilon(1e-5));
  CHECK(white_albedo("half", 0.3f, up) < 0.1);
  CHECK(white_albedo("half", 0.3f, at_cosine(0.1f)) > 10);
}

TEST_CASE("mistakes: without masking nothing is wrong from above, and light is made at rims") {
  // From above G2 is near 1 for narrow lobes: no highlight shows it. At the rim the albedo goes up
  // to 1 / G1, what it would be if no facet sent light down.
  CHECK(white_albedo("masking", 0.1f, up) == close_to(1.0, 0.015));
  for (const float alpha : {0.1f, 0.6f}) {
    const double at_rim = white_albedo("masking", alpha, at_cosine(0.1f));
    CHECK(at_rim > 1.1);
    CHECK(at_rim < 1 / g1_by_cosine(alpha, 0.1));
  }
  CHECK(white_albedo("masking", 0.1f, at_cosine(0.01f)) > 3.0);
}

TEST_CASE("mistakes: without the four everything is four times as bright, and reciprocal") {
  const AnyBrdf wrong = white("four", 0.3f);
  CHECK(white_albedo("four", 0.3f, up) == close_to(4 * 0.8774, 1e-3));
  CHECK(wrong(at_degrees(20), at_degrees(60)).g ==
        Approx(wrong(at_degrees(60), at_degrees(20)).g).epsilon(1e-5));
}

TEST_CASE("mistakes: as printed D is not reciprocal") {
  // Computed independently (errata of thesis eq. 6), alpha 0.3: light from 20 degrees seen from 60,
  // and the other way round.
  const AnyBrdf wrong = white("printed", 0.3f);
  CHECK(wrong(at_degrees(60), at_degrees(20)).g == close_to(0.3703, 1e-4));
  CHECK(wrong(at_degrees(20), at_degrees(60)).g == close_to(0.0239, 1e-4));
}

TEST_CASE("mistakes: as printed light is lost from above and made at the rim") {
  // The same source: albedos at cosines 1, 0.5 and 0.1 with alpha 0.1, F = 1, instead of 0.988,
  // 0.969 and 0.873.
  CHECK(white_albedo("printed", 0.1f, up) == close_to(0.257, 1e-3));
  CHECK(white_albedo("printed", 0.1f, at_cosine(0.5f)) == close_to(0.511, 1e-3));
  CHECK(white_albedo("printed", 0.1f, at_cosine(0.1f)) == close_to(2.134, 2e-3));
}

TEST_CASE("mistakes: as printed D covers the ground up to a hundred times, or hardly at all") {
  // D no longer depends on h: its integral times the cosine is pi D(theta_i). The same source.
  const float alphas[] = {0.1f, 0.3f, 0.5f, 1.0f};
  const double rows[4][3] = {
      {100, 0.1508, 0.01766}, {11.11, 0.8928, 0.1508}, {4, 1.3061, 0.3787}, {1, 1, 1}};
  const float degrees[] = {0, 30, 60};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      CHECK(pi_ * Ggx{alphas[i]}.d(at_degrees(degrees[j])) == Approx(rows[i][j]).epsilon(1e-3));
}
