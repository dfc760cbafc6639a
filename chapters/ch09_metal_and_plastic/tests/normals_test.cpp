// Both ways to choose a facet: what is common to them, and what each has in closed form.
#include "ch04_monte_carlo/pcg32.hpp"
#include "ch06_importance_sampling/cosine_hemisphere.hpp"
#include "ch09_metal_and_plastic/tests/grid.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

template <class Normals>
std::string complaint_about_normals(float alpha, vec3 wo, int samples) {
  const Ggx ggx{alpha};
  Pcg32 random(1);
  const auto draw = [&] { return std::optional(Normals::sample(ggx, wo, random.next_vec2())); };
  const auto pdf = [&](vec3 h) { return double{Normals::pdf(ggx, wo, h)}; };
  // From near the horizon, facets little beyond the vertical show their backs: the quadrature sees
  // where that begins only in narrow bins.
  const int finer = wo.z < 0.05f ? 4 : 1;
  const DirectionBins bins(24 * finer, 16 * finer, RowSpacing::equal_angle);
  const SamplerReport report = test_sampler(draw, pdf, {samples, bins});
  if (std::abs(report.integral - 1) > 5e-4) return "integral " + std::to_string(report.integral);
  return report.complaint;
}

// The share of facets that show wo their back. A facet's slope towards wo has the density
// alpha^2 / (2 (alpha^2 + s^2)^(3/2)) (GGX's slopes, integrated across wo); it shows its back if
// the slope away from wo is steeper than wo itself, cot(theta).
double share_of_backs(double alpha, double mu) {
  const double cot = mu / std::sqrt(1 - mu * mu);
  return (1 - cot / std::sqrt(alpha * alpha + cot * cot)) / 2;
}

constexpr float last = 1.0f - 0x1p-24f;

}  // namespace

TEST_CASE("all normals: half of them lean by less than atan(alpha)") {
  // tan = alpha sqrt(1/2 / (1 - 1/2)) = alpha; a quarter of them by less than alpha / sqrt(3).
  for (const float alpha : grid_alphas) {
    const vec3 h = AllNormals::sample({alpha}, {}, {0.5f, 0.0f});
    CHECK(h.x / h.z == close_to(alpha, 1e-6));
    const vec3 quarter = AllNormals::sample({alpha}, {}, {0.25f, 0.25f});
    CHECK(quarter.y / quarter.z == close_to(alpha / std::sqrt(3.0f), 1e-6));
    CHECK(AllNormals::sample({alpha}, {}, {0.0f, 0.3f}) == vec3(0, 0, 1));
  }
}

TEST_CASE("all normals: they follow D cos at every width") {
  for (const float alpha : grid_alphas) {
    CAPTURE(alpha);
    CHECK(complaint_about_normals<AllNormals>(alpha, slanting_at(0.5f), 1'000'000) == "");
  }
}

TEST_CASE("all normals: as many show their back as the slopes' distribution says") {
  // At cosine 0.1: 14.6, 34.1, 41.7 and 45.0 % for alpha 0.1, 0.3, 0.6 and 1.
  CHECK(share_of_backs(0.1, 0.1) == close_to(0.1456, 1e-4));
  over_grid([](float alpha, vec3 wo) {
    if (wo.z == 1.0f) return;
    Pcg32 random(2);
    RunningMean backs;
    for (int i = 0; i < 100'000; ++i)
      backs.add(dot(wo, AllNormals::sample({alpha}, wo, random.next_vec2())) <= 0.0f);
    CAPTURE(alpha, wo.z, backs.mean());
    CHECK(z_test(backs, share_of_backs(alpha, wo.z)).agrees());
  });
}

TEST_CASE("visible normals: they follow their density over nine angles and five widths") {
  over_grid([](float alpha, vec3 wo) {
    CAPTURE(alpha, wo.z);
    CHECK(complaint_about_normals<VisibleNormals>(alpha, wo, 100'000) == "");
  });
}

TEST_CASE("visible normals: none shows its back, none faces down") {
  over_grid([](float alpha, vec3 wo) {
    Pcg32 random(3);
    for (int i = 0; i < 20'000; ++i) {
      const vec3 h = VisibleNormals::sample({alpha}, wo, random.next_vec2());
      if (!(h.z > 0.0f && dot(wo, h) > -1e-6f)) {
        CAPTURE(alpha, wo.z, h.z, dot(wo, h));
        REQUIRE(false);
      }
    }
  });
}

TEST_CASE("visible normals: from straight above one sees all normals") {
  const vec3 above(0, 0, 1);
  Pcg32 random(4);
  for (const float alpha : grid_alphas)
    for (int i = 0; i < 1000; ++i) {
      const vec3 h = cosine_hemisphere(random.next_vec2());
      REQUIRE(VisibleNormals::pdf({alpha}, above, h) ==
              Approx(AllNormals::pdf({alpha}, above, h)).epsilon(1e-5));
    }
}

TEST_CASE("visible normals: at alpha 1 and from above they are cosine-weighted directions") {
  // D of a sphere's facets is 1 / pi.
  RunningMean height;
  Pcg32 random(5);
  for (int i = 0; i < 1'000'000; ++i)
    height.add(VisibleNormals::sample({1.0f}, {0, 0, 1}, random.next_vec2()).z);
  CHECK(z_test(height, 2.0 / 3).agrees());
}

TEST_CASE("visible normals: at the horizon and alpha 1 they are those of a half disk's sphere") {
  // Seen from the side, the visible quarter of the sphere projects to half a disk, evenly: the mean
  // height of its points, which are the normals, is 4 / (3 pi); the mean of wo.h is 2/3.
  RunningMean height, towards;
  const vec3 wo = slanting_at(1e-5f);
  Pcg32 random(6);
  for (int i = 0; i < 1'000'000; ++i) {
    const vec3 h = VisibleNormals::sample({1.0f}, wo, random.next_vec2());
    height.add(h.z);
    towards.add(dot(wo, h));
  }
  CHECK(z_test(height, 4 / (3 * double{pi})).agrees());
  CHECK(z_test(towards, 2.0 / 3).agrees());
}

TEST_CASE("normals: the corners of the numbers give unit normals that face up") {
  const float numbers[] = {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, last};
  for (const float alpha : {1e-4f, 1e-3f, 0.1f, 1.0f})
    for (const float mu : {1e-7f, 1e-4f, 0.5f, 1.0f - 0x1p-24f, 1.0f})
      for (const float a : numbers)
        for (const float b : numbers) {
          const vec3 wo = slanting_at(mu);
          CAPTURE(alpha, mu, a, b);
          for (const vec3 h : {AllNormals::sample({alpha}, wo, {a, b}),
                               VisibleNormals::sample({alpha}, wo, {a, b})}) {
            CHECK(std::abs(length(h) - 1.0f) < 1e-6f);
            CHECK(h.z > 0.0f);
          }
        }
}
