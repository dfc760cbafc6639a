#include "ch10_dielectric/specular_albedo.hpp"

#include "ch10_dielectric/tests/coats.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

Coat<> glass_coat(float alpha) {
  return {{alpha}, {glass_index}};
}

// An integral over facets, by chapter 8's grid: another sampler's density has no part in it.
double over_facets(float alpha, float mu) {
  const auto value = [=](vec3 wo, vec3 wi) { return glass_coat(alpha).eval(wo, wi); };
  return albedo(value, alpha, at_cosine(mu), 400);
}

}  // namespace

TEST_CASE("specular albedo: perfect mirrors of alpha 1 from above give back 1 - ln 2") {
  const RoughReflection white{Ggx{1.0f}, PerfectMirror{}};
  CHECK(specular_albedo(white, 1.0f, 200) == close_to(1 - std::log(2.0), 1e-4));
}

TEST_CASE("specular albedo: it is the integral of f cos, for 9 angles and 5 widths") {
  for (const float alpha : five_alphas)
    for (const float degrees : nine_angles) {
      const float mu = at_degrees(degrees).z;
      CHECK(specular_albedo(glass_coat(alpha), mu, 200) / over_facets(alpha, mu) ==
            close_to(1.0, 3e-3));
    }
}

TEST_CASE("specular albedo: it goes with the factor on reflections") {
  const Coat<> full = glass_coat(0.3f);
  const Coat<> less{{0.3f}, {glass_index, 0.45f}};
  for (const float mu : {1.0f, 0.5f, 0.1f})
    CHECK(specular_albedo(less, mu, 30) ==
          Approx(0.45 * specular_albedo(full, mu, 30)).epsilon(1e-5));
}

TEST_CASE("albedo table: between its cosines it is right to a thousandth") {
  for (const float alpha : five_alphas)
    for (int i = 0; i < 40; ++i) {
      const float t = (static_cast<float>(i) + 0.5f) / 40.0f;
      const double exact = specular_albedo(glass_coat(alpha), t * t, 150);
      CHECK(table_of(alpha).at(t * t) == close_to(exact, 1e-3));
    }
}

TEST_CASE("albedo table: at both ends it is a number, and no larger than 1") {
  for (const float alpha : five_alphas) {
    CHECK(table_of(alpha).at(0.0f) < 1.0f);
    CHECK(table_of(alpha).at(0.0f) > table_of(alpha).at(1.0f));
    CHECK(table_of(alpha).at(1.0f) ==
          close_to(specular_albedo(glass_coat(alpha), 1.0f, 150), 1e-3));
  }
}

TEST_CASE("albedo table: a polished coat reflects Fresnel's share, on average 0.0917780") {
  const SpecularAlbedo polished(0.0f, glass_index);
  for (const float mu : {1.0f, 0.77f, 0.5f, 0.2f, 0.05f})
    CHECK(polished.at(mu) == close_to(fresnel_dielectric(double{mu}, 1.0, 1.5), 1e-3));
  CHECK(polished.mean() == close_to(mean_fresnel(1.5), 1e-4));
}

TEST_CASE("albedo table: its mean is that of light from everywhere") {
  for (const float alpha : {0.1f, 1.0f}) {
    const double mean = integrate(
        [=](double mu) {
          return 2 * mu * specular_albedo(glass_coat(alpha), static_cast<float>(mu), 60);
        },
        1e-4, 1, 1e-4);
    CHECK(table_of(alpha).mean() == close_to(mean, 2e-4));
  }
}

TEST_CASE("albedo table: a coat of air's own index reflects nothing") {
  const SpecularAlbedo nothing(0.3f, index_of_air);
  CHECK(nothing.at(0.0f) == 0.0f);
  CHECK(nothing.at(0.5f) == 0.0f);
  CHECK(nothing.mean() == 0.0f);
}
