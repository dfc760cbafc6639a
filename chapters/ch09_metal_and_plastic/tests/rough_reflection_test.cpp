#include "ch09_metal_and_plastic/rough_reflection.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch09_metal_and_plastic/tests/directions.hpp"
#include "ch09_metal_and_plastic/tests/grid.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

constexpr float last = 1.0f - 0x1p-24f;

using RoughGold = RoughReflection<ConductorFresnel>;
using RoughGlass = RoughReflection<DielectricFresnel, AllNormals, g2_separable>;

}  // namespace

static_assert(Bsdf<RoughGold>);
static_assert(Bsdf<RoughGlass>);

TEST_CASE("rough reflection: its directions follow its density, nine angles by five widths") {
  over_grid([](float alpha, vec3 wo) {
    CAPTURE(alpha, wo.z);
    CHECK(complaint_about_directions(White<VisibleNormals>{{alpha}, {}}, wo, 100'000) == "");
    CHECK(complaint_about_directions(White<AllNormals>{{alpha}, {}}, wo, 100'000) == "");
  });
}

TEST_CASE("rough reflection: sample, eval and pdf belong together") {
  over_grid([](float alpha, vec3 wo) {
    CAPTURE(alpha, wo.z);
    Pcg32 random(3);
    // A cosine of 1e-3 between wo and h has four digits left in float.
    const double tolerance = std::max(1e-4, 1e-5 / wo.z);
    const auto check = [&](const auto& bsdf) {
      CHECK(triple_complaint(bsdf, wo, 2000, random, tolerance) == "");
    };
    check(RoughGold{{alpha}, {gold}});
    check(RoughGlass{{alpha}, {1.0f, 1.5f}});
    check(White<AllNormals>{{alpha}, {}});
    check(White<VisibleNormals, g2_separable>{{alpha}, {}});
  });
}

TEST_CASE("rough reflection: its density's integral is the share of samples that lead somewhere") {
  for (const float alpha : {0.1f, 0.3f, 1.0f})
    for (const float mu : {0.9f, 0.5f, 0.1f}) {
      const vec3 wo = slanting_at(mu);
      const auto check = [&](const auto& bsdf) {
        const double integral =
            integrate_directions([&](vec3 wi) { return double{bsdf.pdf(wo, wi)}; }, 1e-5);
        CAPTURE(alpha, mu, integral);
        CHECK(std::abs(z_test(accepted(bsdf, wo, 400'000), integral).z) < 6);
      };
      check(White<VisibleNormals>{{alpha}, {}});
      check(White<AllNormals>{{alpha}, {}});
    }
}

TEST_CASE("rough reflection: of the lost share, four digits agree") {
  const vec3 wo = slanting_at(0.1f);
  const White<VisibleNormals> bsdf{{0.6f}, {}};
  const double integral =
      integrate_directions([&](vec3 wi) { return double{bsdf.pdf(wo, wi)}; }, 1e-6);
  CHECK(accepted(bsdf, wo, 4'000'000).mean() == close_to(integral, 5e-4));
}

TEST_CASE("rough reflection: no direction below the horizon carries weight") {
  over_grid([](float alpha, vec3 wo) {
    Pcg32 random(4);
    const auto check = [&](const auto& bsdf) {
      for (int i = 0; i < 5000; ++i) {
        const vec3 u = random.next_vec3();
        const auto sample = bsdf.sample(wo, u);
        if (sample) REQUIRE(sample->wi.z > 0.0f);
        const vec3 below = -cosine_hemisphere(vec2(u));
        REQUIRE(bsdf.eval(wo, below) == Rgb(0.0f));
        REQUIRE(bsdf.pdf(wo, below) == 0.0f);
        REQUIRE(!bsdf.sample(below, u));  // nor is anything seen from below
      }
    };
    check(White<VisibleNormals>{{alpha}, {}});
    check(White<AllNormals>{{alpha}, {}});
  });
}

TEST_CASE("rough reflection: it is chapter 8's surface, asked in another way") {
  Pcg32 random(5);
  const MicrofacetReflection before{Ggx{0.3f}, ConductorFresnel{gold}};
  for (int i = 0; i < 1000; ++i) {
    const vec3 wo = cosine_hemisphere(random.next_vec2());
    const vec3 wi = cosine_hemisphere(random.next_vec2());
    REQUIRE(RoughGold{{0.3f}, {gold}}.eval(wo, wi) == before.eval(wo, wi));
  }
}

TEST_CASE("rough reflection: the same both ways, 10,000 pairs") {
  Pcg32 random(6);
  for (int i = 0; i < 10'000; ++i) {
    const vec3 wo = cosine_hemisphere(random.next_vec2());
    const vec3 wi = cosine_hemisphere(random.next_vec2());
    const RoughGold bsdf{{grid_alphas[i % 5]}, {gold}};
    REQUIRE(bsdf.eval(wo, wi).b == Approx(bsdf.eval(wi, wo).b).epsilon(1e-4));
  }
}

TEST_CASE("rough reflection: a million corners, nothing is infinite or NaN") {
  const float alphas[] = {1e-4f, 1e-3f, 0.1f, 1.0f};
  const float cosines[] = {1e-30f, 1e-15f, 1e-7f, 1e-4f, 0.1f, 1.0f - 0x1p-24f, 1.0f};
  const float numbers[] = {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, last};
  const float indices[] = {1.0f, 1.0f - 1e-6f, 1.0f + 1e-6f, 1.5f, 3.0f};
  Pcg32 random(7);
  const auto any_of = [&](const auto& list) {
    return list[static_cast<int>(random.next_float() * static_cast<float>(std::size(list)))];
  };
  const auto check = [&](const auto& bsdf, vec3 wo, vec3 wi, vec3 u) {
    const Rgb f = bsdf.eval(wo, wi);
    const float p = bsdf.pdf(wo, wi);
    const auto sample = bsdf.sample(wo, u);
    const bool is_good =
        f.g >= 0.0f && std::isfinite(f.g) && p >= 0.0f && std::isfinite(p) &&
        (!sample || (std::abs(length(sample->wi) - 1.0f) < 1e-5f && sample->wi.z > 0.0f &&
                     sample->weight.g >= 0.0f && std::isfinite(sample->weight.g) &&
                     sample->pdf > 0.0f && std::isfinite(sample->pdf)));
    if (is_good) return;
    CAPTURE(bsdf.ggx.alpha, wo.z, wi.z, u.x, u.y, f.g, p);
    REQUIRE(is_good);
  };
  for (int i = 0; i < 500'000; ++i) {
    const Ggx ggx{any_of(alphas)};
    const vec3 wo = slanting_at(i % 3 ? any_of(cosines) : random.next_float());
    const vec3 wi = slanting_at(any_of(cosines)) * vec3(i % 2 ? -1.0f : 1.0f, 1.0f, 1.0f);
    const vec3 u(any_of(numbers), any_of(numbers), any_of(numbers));
    const float beyond = any_of(indices);
    check(RoughReflection{ggx, DielectricFresnel{1.0f, beyond}}, wo, wi, u);
    check(White<AllNormals>{ggx, {}}, wo, i % 5 ? wi : vec3(-wo.x, -wo.y, wo.z), u);
  }
  CHECK_FALSE(RoughGold{{0.1f}, {gold}}.sample({1, 0, 0}, vec3(0.5f)));  // along the surface
}
