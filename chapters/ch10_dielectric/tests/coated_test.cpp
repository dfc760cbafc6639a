#include "ch10_dielectric/coated.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch09_metal_and_plastic/tests/directions.hpp"
#include "ch10_dielectric/tests/coats.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

static_assert(Bsdf<CoatedDiffuse<ReciprocalBase>>);
static_assert(Bsdf<CoatedDiffuse<ThesisBase, FixedChoice, g2_separable>>);
static_assert(Bsdf<CoatedDiffuse<ConservingBase>>);

namespace {

const Rgb tint(0.2f, 0.5f, 0.8f);

CoatedDiffuse<ReciprocalBase> tinted(float alpha) {
  return coated(alpha, reciprocal_base(tint));
}

// Share of u that lead to a direction: the base's all do; of the coat's, one is taken at random in
// each cell of a grid, because the edge of those that do follows the rows of the grid.
double accepted(const CoatedDiffuse<ReciprocalBase>& bsdf, vec3 wo, int steps) {
  Pcg32 random(6);
  int count = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const vec2 u = (vec2(i, j) + random.next_vec2()) / static_cast<float>(steps);
      count += bsdf.coat.sample(wo, vec3(u, 0.0f)).has_value();
    }
  const double p = bsdf.coat_probability(wo);
  return 1 - p + p * count / steps / steps;
}

}  // namespace

TEST_CASE("coated: it is the coat's lobe and the base's, added") {
  const auto bsdf = tinted(0.3f);
  const vec3 wo = slanting(50), wi = at_degrees(-35);
  CHECK(bsdf.eval(wo, wi) == bsdf.coat.eval(wo, wi) + bsdf.base.eval(wo, wi));
  // Straight on: F D / 4 + 0.96^2 c / pi, F = 0.04, D = 1 / (pi alpha^2).
  const vec3 up(0, 0, 1);
  const double mirrored = 0.04 / (4 * pi_ * 0.09);
  CHECK(bsdf.eval(up, up).g == close_to(mirrored + 0.96 * 0.96 * 0.5 / pi_, 1e-6));
}

TEST_CASE("coated: directions come as the mixture's density says, for 9 angles and 5 widths") {
  over_grid([](float alpha, vec3 wo) {
    CHECK(complaint_about_directions(tinted(alpha), wo, 20'000) == "");
  });
}

TEST_CASE("coated: sample, eval and pdf belong together, for 9 angles and 5 widths") {
  Pcg32 random(2);
  over_grid([&](float alpha, vec3 wo) {
    with_each_base(alpha, tint, [&](const auto& bsdf) {
      CHECK(triple_complaint(bsdf, wo, 1'000, random) == "");
    });
  });
}

TEST_CASE("coated: the density's integral is the share of samples that lead anywhere") {
  over_grid([](float alpha, vec3 wo) {
    const auto bsdf = tinted(alpha);
    const auto over_cosine = [&](vec3 from, vec3 wi) { return Rgb(bsdf.pdf(from, wi) / wi.z); };
    // Chapter 8's grid of facets wants wo in the plane of x and z; wide enough for the base, too.
    CHECK(albedo(over_cosine, std::max(alpha, 0.3f), at_cosine(wo.z), 600) ==
          close_to(accepted(bsdf, wo, 400), 5e-4));
  });
}

TEST_CASE("coated: light goes both ways alike, for 10,000 pairs of directions") {
  Pcg32 random(3);
  for (int i = 0; i < 10'000; ++i) {
    const float alpha = five_alphas[random.next_bits() % 5];
    const vec3 wo = uniform_hemisphere(random.next_vec2());
    const vec3 wi = uniform_hemisphere(random.next_vec2());
    with_each_base(alpha, tint, [&](const auto& bsdf) {
      const Rgb there = bsdf.eval(wo, wi);
      REQUIRE(distance(bsdf.eval(wi, wo), there) <= 1e-4f * length(there));
    });
  }
}

TEST_CASE("coated: no sample weighs more than either lobe does, paid for its choice") {
  // w = (f_s + f_d) cos / (p p_s + (1 - p) p_d) lies between both quotients. Here the coat's is at
  // most F / p with F <= 1, the base's pi f_d / (1 - p) <= 1 / (1 - p).
  Pcg32 random(4);
  over_grid([&](float alpha, vec3 wo) {
    const auto bsdf = coated(alpha, reciprocal_base(Rgb(1.0f)));
    const float p = bsdf.coat_probability(wo);
    for (int i = 0; i < 1'000; ++i) {
      const auto sample = bsdf.sample(wo, random.next_vec3());
      if (sample) REQUIRE(sample->weight.g <= 1.001f * std::max(1 / p, 1 / (1 - p)));
    }
  });
}

TEST_CASE("coated: nothing comes from below or goes there") {
  const auto bsdf = tinted(0.5f);
  const vec3 up(0, 0, 1);
  for (const vec3 low : {vec3(1, 0, 0), vec3(0.6f, 0.0f, -0.8f)}) {
    CHECK(bsdf.eval(low, up) == Rgb(0.0f));
    CHECK(bsdf.eval(up, low) == Rgb(0.0f));
    CHECK(bsdf.pdf(low, up) == 0.0f);
    CHECK(bsdf.pdf(up, low) == 0.0f);
    CHECK_FALSE(bsdf.sample(low, vec3(0.5f)));
  }
}

TEST_CASE("coated: over a black base it is the coat alone") {
  const auto bsdf = coated(0.3f, reciprocal_base(Rgb(0.0f)));
  const vec3 wo = slanting(60);
  CHECK(bsdf.coat_probability(wo) == 1.0f);
  Pcg32 random(5);
  for (int i = 0; i < 1'000; ++i) {
    const vec3 u = random.next_vec3();
    const auto alone = bsdf.coat.sample(wo, u);
    const auto sample = bsdf.sample(wo, u);
    REQUIRE(sample.has_value() == alone.has_value());
    if (sample) REQUIRE(distance(sample->weight, alone->weight) < 1e-4f);
  }
}
