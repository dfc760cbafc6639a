#include "ch11_refraction/rough_glass.hpp"

#include "ch09_metal_and_plastic/tests/directions.hpp"
#include "ch11_refraction/tests/glasses.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

static_assert(Bsdf<RoughGlass<>>);
static_assert(Bsdf<RoughGlass<AllNormals, g2_separable>>);

namespace {

// The integral over all directions on a grid of equal solid angles: of no high order, but a jump,
// as where facets would have to lean by more than 90 degrees, costs it little.
template <class F>
double over_all_directions(const F& f, int steps) {
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double z = 1 - 2 * (i + 0.5) / steps, phi = 2 * pi_ * (j + 0.5) / steps;
      const double radius = std::sqrt(1 - z * z);
      sum += f(vec3(radius * std::cos(phi), radius * std::sin(phi), z));
    }
  return 4 * pi_ * sum / steps / steps;
}

// Squared cosine beyond the facet; near 0, at the critical angle, Fresnel's share and the cosine
// are roots of a small difference, and a float's last digit is felt in the fourth.
double squared_cos_of(const auto& glass, vec3 wo, vec3 wi) {
  const vec3 h = wi.z > 0.0f ? half_vector(wo, wi)
                             : transmission_half_vector(wo, wi, glass.n_here, glass.n_beyond);
  return squared_cos_beyond<double>(dot(wo, h), double{glass.n_here} / double{glass.n_beyond});
}

// A rough glass that keeps silent near the critical angle, or else there alone.
template <class Glass>
struct Part {
  Glass glass;
  bool is_critical;

  Rgb eval(vec3 wo, vec3 wi) const { return glass.eval(wo, wi); }
  float pdf(vec3 wo, vec3 wi) const { return glass.pdf(wo, wi); }
  std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const auto found = glass.sample(wo, u);
    if (!found) return found;
    const bool critical = std::abs(squared_cos_of(glass, wo, found->wi)) < 0.01;
    return critical == is_critical ? found : std::nullopt;
  }
};

template <class Glass>
Part(Glass, bool) -> Part<Glass>;

// The same two directions seen from the other side of the surface.
vec3 from_behind(vec3 w) {
  return {w.x, w.y, -w.z};
}

}  // namespace

TEST_CASE("rough glass: straight through it is known: 9 (1 - F) D / 2.25 into glass, 4 ... 2.25") {
  // h = n, G = 1, D = 1 / (pi alpha^2), F = 0.04. The Jacobian is 9 into glass and 4 out of it;
  // f cos = (1 - F) D Jacobian eta^2.
  const vec3 up(0, 0, 1);
  const double d = 1 / (pi_ * 0.09);
  CHECK(into(0.3f).eval(up, -up).g == Approx(0.96 * d * 9 / 2.25).epsilon(1e-5));
  CHECK(out_of(0.3f).eval(up, -up).g == Approx(0.96 * d * 4 * 2.25).epsilon(1e-5));
  CHECK(into(0.3f).pdf(up, -up) == Approx(0.96 * d * 9).epsilon(1e-5));
}

TEST_CASE("rough glass: what comes through is Walter's equation 21, what is mirrored chapter 9's") {
  Pcg32 random(3);
  for (int i = 0; i < 20'000; ++i) {
    const float alpha = grid_alphas[i % 5];
    const auto glass = i % 2 ? into(alpha) : out_of(alpha);
    const vec3 wo = uniform_hemisphere(random.next_vec2());
    const vec3 wi = uniform_below(random.next_vec2());
    if (wo.z < 0.01f || wi.z > -0.01f) continue;
    const double exact = Btdf{alpha, glass.n_here, glass.n_beyond}.value(wo, wi);
    CAPTURE(alpha, glass.n_here, wo, wi, exact);
    // Near the critical angle 1 - F is the root of a small difference; D of steep facets is small.
    REQUIRE(glass.eval(wo, wi).g == close_to(exact, 1e-3 * exact + 1e-4));
    const RoughReflection<DielectricFresnel> mirror{{alpha}, {glass.n_here, glass.n_beyond}};
    REQUIRE(glass.eval(wo, from_behind(wi)) == mirror.eval(wo, from_behind(wi)));
  }
}

TEST_CASE("rough glass: directions follow the density: 9 angles, 5 widths, both sides") {
  over_both_sides([](const auto& glass, vec3 wo) {
    CAPTURE(glass.ggx.alpha, glass.n_here, wo.z);
    CHECK(complaint_about_directions(glass, wo, 20'000) == "");
  });
}

TEST_CASE("rough glass: with all normals and separable masking the directions follow it too") {
  for (const float mu : {0.9f, 0.3f}) {
    const RoughGlass<AllNormals, g2_separable> in{{0.3f}, 1.0f, 1.5f}, out{{0.3f}, 1.5f, 1.0f};
    CHECK(complaint_about_directions(in, slanting_at(mu), 20'000) == "");
    CHECK(complaint_about_directions(out, slanting_at(mu), 20'000) == "");
  }
}

TEST_CASE("rough glass: sample, eval and pdf belong together, from both sides") {
  Pcg32 random(4);
  over_both_sides([&](const auto& glass, vec3 wo) {
    CAPTURE(glass.ggx.alpha, glass.n_here, wo.z);
    // A cosine of 1e-3 between wo and h has four digits left.
    const double tolerance = std::max(1e-4, 1e-5 / wo.z);
    const auto check = [&](const auto& any) {
      CHECK(triple_complaint(Part{any, false}, wo, 2'000, random, tolerance) == "");
      CHECK(triple_complaint(Part{any, true}, wo, 2'000, random, 0.05) == "");
    };
    check(glass);
    check(RoughGlass<AllNormals, g2_separable>{glass.ggx, glass.n_here, glass.n_beyond});
  });
}

TEST_CASE("rough glass: the density's integral is the share of samples that lead somewhere") {
  for (const float alpha : {0.1f, 0.3f, 1.0f})
    for (const float mu : {0.9f, 0.5f, 0.1f})
      for (const auto& glass : {into(alpha), out_of(alpha)}) {
        const vec3 wo = slanting_at(mu);
        const double integral =
            over_all_directions([&](vec3 wi) { return glass.pdf(wo, wi); }, 1500);
        const RunningMean share = accepted(glass, wo, 400'000);
        CAPTURE(alpha, mu, glass.n_here, integral, share.mean());
        CHECK(z_test(share, integral).agrees(5e-4));
      }
}

TEST_CASE("rough glass: every direction is unit, and none carries weight along the surface") {
  Pcg32 random(5);
  over_both_sides([&](const auto& glass, vec3 wo) {
    for (int i = 0; i < 2'000; ++i) {
      const auto sample = glass.sample(wo, random.next_vec3());
      if (!sample) continue;
      REQUIRE(length(sample->wi) == close_to(1.0, 1e-5));
      REQUIRE(sample->wi.z != 0.0f);
      REQUIRE(sample->pdf > 0.0f);
    }
  });
  CHECK_FALSE(into(0.3f).sample({1, 0, 0}, vec3(0.5f)));
  CHECK_FALSE(into(0.3f).sample({0, 0, -1}, vec3(0.5f)));
  CHECK(into(0.3f).eval({0, 0, -1}, {0, 0, 1}) == Rgb(0.0f));
  CHECK(into(0.3f).pdf({0, 0, -1}, {0, 0, 1}) == 0.0f);
  CHECK(into(0.3f).eval({0, 0, 1}, {1, 0, 0}) == Rgb(0.0f));
}

TEST_CASE("rough glass: with visible normals no sample weighs more than 1, or eta^2 beyond") {
  Pcg32 random(6);
  over_both_sides([&](const auto& glass, vec3 wo) {
    const float eta = glass.n_here / glass.n_beyond;
    for (int i = 0; i < 5'000; ++i) {
      const auto sample = glass.sample(wo, random.next_vec3());
      if (!sample) continue;
      const float most = sample->wi.z > 0.0f ? 1.0f : eta * eta;
      REQUIRE(sample->weight.g <= most * (1.0f + 1e-6f));
    }
  });
}

TEST_CASE("rough glass: light goes both ways alike, up to eta^2, for 10,000 pairs") {
  Pcg32 random(7);
  for (int i = 0; i < 10'000; ++i) {
    const float alpha = grid_alphas[i % 5];
    const vec3 wo = uniform_hemisphere(random.next_vec2());
    const vec3 wi = uniform_below(random.next_vec2());
    if (wo.z < 1e-3f || wi.z > -1e-3f) continue;
    if (std::abs(squared_cos_of(out_of(alpha), from_behind(wi), from_behind(wo))) < 0.01) continue;
    const double there = into(alpha).eval(wo, wi).g / 1.0;
    const double back = out_of(alpha).eval(from_behind(wi), from_behind(wo)).g / 2.25;
    CAPTURE(alpha, wo, wi);
    REQUIRE(there == close_to(back, 1e-3 * back));
    const vec3 up = from_behind(wi);
    REQUIRE(into(alpha).eval(wo, up).g == Approx(into(alpha).eval(up, wo).g).epsilon(1e-3));
  }
}

TEST_CASE("rough glass: beyond the critical angle of every facet nothing comes through") {
  // From glass into air at 60 degrees, nearly smooth: the facet would have to lean by 18 degrees,
  // and of alpha 0.001 one in 100,000 does.
  Pcg32 random(8);
  for (int i = 0; i < 10'000; ++i) {
    const auto sample = out_of(1e-3f).sample(slanting_at(0.5f), random.next_vec3());
    REQUIRE((!sample || sample->wi.z > 0.0f));
  }
}

TEST_CASE("rough glass: masking through it lies between both sides' darkest and brightest forms") {
  // Height-correlated for opposite sides (Heitz et al. 2016): the integral of u^a (1 - u)^b, which
  // is at most the separable form; and 1 / (1 + a + b), chapter 8's form, is above both.
  Pcg32 random(9);
  for (int i = 0; i < 1'000; ++i) {
    const Ggx ggx{grid_alphas[i % 5]};
    const vec3 wo = uniform_hemisphere(random.next_vec2());
    const vec3 wi = uniform_below(random.next_vec2());
    if (wo.z < 0.01f || wi.z > -0.01f) continue;
    const double a = ggx.lambda(wo), b = ggx.lambda(wi);
    const double beta = std::exp(std::lgamma(1 + a) + std::lgamma(1 + b) - std::lgamma(2 + a + b));
    REQUIRE(g2_through(ggx, wo, wi) >= beta * (1 - 1e-4));
    REQUIRE(g2_through(ggx, wo, wi) <= (1 + 1e-6) / (1 + a + b));
  }
}
