#include "ch08_microfacets/microfacet.hpp"

#include <vector>

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "ch08_microfacets/albedo.hpp"
#include "ch08_microfacets/tests/oracles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

template <class Fresnel>
using Separable = MicrofacetReflection<Fresnel, g2_separable>;

const ConductorFresnel golden{gold};
const DielectricFresnel glassy{1.0f, 1.5f};

/// F = 1.
template <class Bsdf>
double white_albedo(const Bsdf& bsdf, vec3 wo, int steps = 500) {
  return albedo([&](vec3 o, vec3 i) { return bsdf.eval(o, i); }, bsdf.ggx.alpha, wo, steps);
}
MicrofacetReflection<PerfectMirror> white(float alpha) {
  return {Ggx{alpha}, {}};
}
Separable<PerfectMirror> white_separable(float alpha) {
  return {Ggx{alpha}, {}};
}

/// Mean weight of the cosine's directions over a grid: the same integral in another way, good for
/// wide lobes only.
double mean_weight(const MicrofacetReflection<PerfectMirror>& bsdf, vec3 wo, int steps) {
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const vec2 u = (vec2(i, j) + 0.5f) / static_cast<float>(steps);
      sum += bsdf.sample(wo, vec3(u, 0.5f))->weight.g;
    }
  return sum / steps / steps;
}

template <class AnyBsdf>
void require_reciprocal(const AnyBsdf& bsdf, Pcg32& random) {
  const vec3 wo = uniform_hemisphere(random.next_vec2());
  const vec3 wi = uniform_hemisphere(random.next_vec2());
  const Rgb there = bsdf.eval(wo, wi);
  REQUIRE(distance(bsdf.eval(wi, wo), there) <= 1e-5f * length(there));
}

}  // namespace

static_assert(Bsdf<MicrofacetReflection<PerfectMirror>>);
static_assert(Bsdf<MicrofacetReflection<DielectricFresnel>>);
static_assert(Bsdf<Separable<ConductorFresnel>>);

TEST_CASE("microfacet: with alpha 1, seen from above, light comes back as 1 - ln 2") {
  // D = 1/pi, G2 = 2 mu / (1 + mu), f cos = mu / (2 pi (1 + mu)); times 2 pi, over mu from 0 to 1.
  const double closed = 1 - std::log(2.0);
  CHECK(white_albedo(white(1.0f), {0, 0, 1}) == close_to(closed, 1e-5));
  CHECK(white_albedo(white_separable(1.0f), {0, 0, 1}) == close_to(closed, 1e-5));
  CHECK(mean_weight(white(1.0f), {0, 0, 1}, 500) == close_to(closed, 1e-5));
}

TEST_CASE("microfacet: straight on it is F D / 4") {
  // mu = 1 twice, G2 = 1: (1 / (pi alpha^2)) / 4.
  const vec3 up(0, 0, 1);
  for (const float alpha : {0.1f, 0.5f, 1.0f}) {
    const double peak = 1 / (4 * pi_ * alpha * alpha);
    CHECK(MicrofacetReflection{Ggx{alpha}, PerfectMirror{}}.eval(up, up).g ==
          Approx(peak).epsilon(1e-6));
    CHECK(MicrofacetReflection{Ggx{alpha}, glassy}.eval(up, up).g ==
          Approx(0.04 * peak).epsilon(1e-5));
    // Chapter 7's gold, straight on: 0.9310, 0.7869, 0.4015.
    CHECK(MicrofacetReflection{Ggx{alpha}, golden}.eval(up, up) / static_cast<float>(peak) ==
          close_to(Rgb(0.9310f, 0.7869f, 0.4015f), 1e-4));
  }
}

TEST_CASE("microfacet: Fresnel's angle is that to the facet, not to the surface") {
  // wo and wi 60 degrees to either side meet the facet at 60 degrees: 0.0891867. On the same side
  // they meet the facet between them straight on: 0.04.
  const MicrofacetReflection glass{Ggx{1.0f}, glassy};
  const MicrofacetReflection white{Ggx{1.0f}, PerfectMirror{}};
  const vec3 left = at_degrees(-60), right = at_degrees(60);
  CHECK(glass.eval(left, right).g / white.eval(left, right).g == close_to(0.0891867, 1e-6));
  CHECK(glass.eval(right, right).g / white.eval(right, right).g == close_to(0.04, 1e-6));
}

TEST_CASE("microfacet: light goes both ways alike, for 10,000 pairs of directions") {
  Pcg32 random(1);
  for (int i = 0; i < 10'000; ++i) {
    const Ggx ggx{std::max(1e-4f, random.next_float())};
    require_reciprocal(MicrofacetReflection{ggx, PerfectMirror{}}, random);
    require_reciprocal(MicrofacetReflection{ggx, glassy}, random);
    require_reciprocal(MicrofacetReflection{ggx, golden}, random);
    require_reciprocal(Separable<ConductorFresnel>{ggx, golden}, random);
  }
}

TEST_CASE("microfacet: nothing comes from below or goes there") {
  const MicrofacetReflection bsdf{Ggx{0.5f}, PerfectMirror{}};
  const vec3 up(0, 0, 1);
  CHECK(bsdf.eval(up, -up) == Rgb(0.0f));
  CHECK(bsdf.eval(-up, up) == Rgb(0.0f));
  CHECK(bsdf.eval(-up, -up) == Rgb(0.0f));
  CHECK(bsdf.eval(up, {1, 0, 0}) == Rgb(0.0f));
  CHECK(bsdf.eval({1, 0, 0}, {-1, 0, 0}) == Rgb(0.0f));
}

TEST_CASE("microfacet: albedos of perfect mirrors never exceed 1 and are those of the papers' G") {
  // D, G and F = 1 by the papers' formulas, in double: 9 angles, 5 widths, both forms of G.
  for (const float alpha : five_alphas)
    for (const float degrees : nine_angles) {
      const vec3 wo = at_degrees(degrees);
      const double correlated = white_albedo(white(alpha), wo, 300);
      const double separable = white_albedo(white_separable(alpha), wo, 300);
      CHECK(correlated <= 1.0);
      CHECK(separable <= correlated);
      CHECK(correlated / albedo_over_facets(alpha, wo.z, true, 400) == close_to(1.0, 2e-3));
      CHECK(separable / albedo_over_facets(alpha, wo.z, false, 400) == close_to(1.0, 2e-3));
    }
}

TEST_CASE("microfacet: an integral over facets is one over directions") {
  // Nothing is shared but eval(): the solid angle of each facet's light, 4 cos, is tested here.
  for (const float alpha : {0.3f, 0.6f, 1.0f})
    for (const float degrees : {0.0f, 30.0f, 60.0f, 75.0f}) {
      const vec3 wo = at_degrees(degrees);
      CHECK(white_albedo(white(alpha), wo, 300) / mean_weight(white(alpha), wo, 500) ==
            close_to(1.0, 1e-3));
    }
}

TEST_CASE("microfacet: albedos published for this model") {
  // F = 1, seen from above: errata of thesis eq. 5.
  const std::pair<float, double> above[] = {{0.1f, 0.9883}, {0.3f, 0.8774}, {0.6f, 0.5915}};
  for (const auto& [alpha, expected] : above)
    CHECK(white_albedo(white(alpha), {0, 0, 1}) == close_to(expected, 1e-4));
  // alpha 0.1, separable, at the cosines 0.5 and 0.1.
  CHECK(white_albedo(white_separable(0.1f), at_cosine(0.5f)) == close_to(0.969, 6e-4));
  CHECK(white_albedo(white_separable(0.1f), at_cosine(0.1f)) == close_to(0.873, 6e-4));
  // alpha 0.5 at the cosine 0.9: 0.683 separable, 0.684 correlated.
  CHECK(white_albedo(white(0.5f), at_cosine(0.9f)) == close_to(0.684, 6e-4));
  CHECK(white_albedo(white_separable(0.5f), at_cosine(0.9f)) == close_to(0.683, 6e-4));
}

TEST_CASE("microfacet: sample, eval and pdf belong together, for 9 angles and 5 widths") {
  Pcg32 random(2);
  for (const float alpha : five_alphas)
    for (const float degrees : nine_angles) {
      CHECK(triple_complaint(MicrofacetReflection{Ggx{alpha}, golden}, at_degrees(degrees), 2'000,
                             random) == "");
    }
}

TEST_CASE("microfacet: from above, the mean square of a weight is 1 / (12 alpha^2)") {
  // Under an even sky the mean is 1, so this is what the noise comes from. Weight w = pi f at the
  // density cos / pi: the integral of pi f^2 cos. Near the mirror direction f = D / 4, and light
  // has 4 times the solid angle of its facets: pi / 4 times the integral of D^2, which is in slopes
  // 2 pi t alpha^4 / (pi^2 (alpha^2 + t^2)^4), in sum 1 / (3 pi alpha^2).
  for (const float alpha : {0.005f, 0.01f, 0.02f, 0.05f}) {
    const auto bsdf = white(alpha);
    const auto squared = [&](vec3 wo, vec3 wi) {
      const Rgb f = bsdf.eval(wo, wi);
      return pi * f * f;
    };
    const double mean_square = albedo(squared, alpha, {0, 0, 1}, 500);
    CHECK(mean_square * 12 * alpha * alpha == close_to(1.0, 0.02));
  }
}

TEST_CASE("microfacet: directions come in proportion to the cosine, as the density says") {
  const MicrofacetReflection bsdf{Ggx{0.3f}, golden};
  const vec3 wo = at_degrees(45);
  Pcg32 random(3);
  const auto draw = [&]() -> std::optional<vec3> {
    const auto sample = bsdf.sample(wo, random.next_vec3());
    return sample ? std::optional(sample->wi) : std::nullopt;
  };
  const auto report =
      test_sampler(draw, [&](vec3 wi) { return bsdf.pdf(wo, wi); }, {.samples = 200'000});
  CHECK(report.complaint == "");
}

TEST_CASE("microfacet: a ball under an even sky is as bright as its albedo") {
  UnderSky open{TexturedScene(Scene{{{vec3(0.0f), 1.0f}}, {}, {}}), Rgb(2.0f)};
  const auto rough = [](const Surface&) {
    return MicrofacetReflection{Ggx{0.6f}, PerfectMirror{}};
  };
  // A ray at distance b from the axis meets the ball at the cosine sqrt(1 - b^2).
  for (const float b : {0.0f, 0.6f, 0.9f}) {
    const double expected = 2 * albedo_over_facets(0.6, std::sqrt(1.0 - double{b} * b), true, 400);
    const Ray ray{{b, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
    const RunningMean mean = many(ray, 100'000, [&](const Ray& r, Pcg32& random) {
      return radiance_recursive(open, rough, r, 1, random);
    });
    CHECK(z_test(mean, expected).agrees());
    CHECK(mean.mean() == Approx(expected).epsilon(0.02));
  }
}

TEST_CASE("microfacet: a million evaluations at the corners are finite and not negative") {
  constexpr float last = 1.0f - 0x1p-24f;
  const std::vector<float> cosines{1.0f, 0.5f, 1e-2f, 1e-4f, 1e-7f, 1e-12f, 1e-18f, 1e-20f, 1e-44f};
  const std::vector<float> alphas{1e-4f, 1e-3f, 0.02f, 0.3f, 1.0f};
  Pcg32 random(4);
  int count = 0;
  const auto corner_or = [&](float inner) {  // 0, the last number, or any between
    const float choice = random.next_float();
    return choice < 0.3f ? 0.0f : choice < 0.6f ? last : inner;
  };
  const auto direction = [&](float mu, float turn) {
    const float radius = std::sqrt((1 - mu) * (1 + mu));
    return vec3(radius * std::cos(turn), radius * std::sin(turn), mu);
  };
  const auto require_good = [&](Rgb f) {
    REQUIRE(std::isfinite(f.r + f.g + f.b));
    REQUIRE(std::min({f.r, f.g, f.b}) >= 0.0f);
    ++count;
  };
  const auto evaluate = [&](const auto& bsdf, vec3 wo, vec3 wi, vec3 u) {
    require_good(bsdf.eval(wo, wi));
    const auto sample = bsdf.sample(wo, u);
    require_good(sample->weight);
    require_good(bsdf.eval(wo, sample->wi));
  };
  while (count < 1'000'000)
    for (const float alpha : alphas)
      for (const float mu_o : cosines)
        for (const float mu_i : cosines) {
          const float inner = random.next_float();
          const float other = random.next_float();
          const vec3 u(corner_or(inner), corner_or(other), 0.5f);
          const float turn = u.y < 0.5f ? pi : 2 * pi * other;  // straight across, or anywhere
          const vec3 wo = direction(mu_o, 0.0f), wi = direction(mu_i, turn);
          evaluate(MicrofacetReflection{Ggx{alpha}, golden}, wo, wi, u);
          evaluate(Separable<DielectricFresnel>{Ggx{alpha}, glassy}, wo, wi, u);
          evaluate(MicrofacetReflection{Ggx{alpha}, PerfectMirror{}}, wo, wi, u);
        }
}
