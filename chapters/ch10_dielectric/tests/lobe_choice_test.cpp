#include "ch10_dielectric/lobe_choice.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch10_dielectric/choice_price.hpp"
#include "ch10_dielectric/tests/coats.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

static_assert(LobeChoice<ByShare> && LobeChoice<FixedChoice>);

namespace {

double variance_of(float mu, float p) {
  return weight_moments(grey_coated(0.1f, FixedChoice{p}), at_cosine(mu), 100).variance;
}

}  // namespace

TEST_CASE("lobe choice: by share is the coat's part of the sum, and never 0 / 0") {
  CHECK(ByShare{}(0.04f, 0.36f) == close_to(0.1f, 1e-7));
  CHECK(ByShare{}(0.5f, 0.0f) == 1.0f);
  CHECK(ByShare{}(0.0f, 0.5f) == 0.0f);
  CHECK(ByShare{}(0.0f, 0.0f) == 0.0f);
}

TEST_CASE("lobe choice: the mean is the same for the probabilities 0.1, 0.5 and 0.9") {
  for (const float mu : {1.0f, 0.5f, 0.1f}) {
    const auto grey = grey_coated(0.1f, ByShare{});
    const double expected = total_albedo(grey.coat.fresnel, grey.base, 0.1f, mu, 200);
    for (const float p : {0.1f, 0.5f, 0.9f}) {
      CHECK(weight_moments(grey_coated(0.1f, FixedChoice{p}), at_cosine(mu), 200).mean ==
            close_to(expected, 1e-3));
      RunningMean mean;  // and with random numbers
      Pcg32 random(1);
      for (int i = 0; i < 20'000; ++i) {
        const auto sample =
            grey_coated(0.1f, FixedChoice{p}).sample(at_cosine(mu), random.next_vec3());
        mean.add(sample ? double{sample->weight.g} : 0.0);
      }
      CHECK(z_test(mean, expected).agrees(1e-3));
    }
  }
}

TEST_CASE("lobe choice: with any probability sample, eval and pdf belong together") {
  Pcg32 random(2);
  for (const float p : {0.1f, 0.5f, 0.9f})
    CHECK(triple_complaint(grey_coated(0.3f, FixedChoice{p}), slanting(60), 5'000, random) == "");
}

TEST_CASE("lobe choice: the variance is least near the shares, and far off tenfold") {
  // Where lobes hardly overlap, a weight is total / p or total / (1 - p), and both are the total if
  // p is the share.
  for (const float mu : {1.0f, 0.3f, 0.1f}) {
    const auto grey = grey_coated(0.1f, ByShare{});
    const float share = grey.coat_probability(at_cosine(mu));
    double least = 1e9;
    for (int i = 1; i < 50; ++i)
      least = std::min(least, variance_of(mu, static_cast<float>(i) / 50.0f));
    const double by_share = weight_moments(grey, at_cosine(mu), 100).variance;
    CHECK(by_share < 1.15 * least);
    CHECK(variance_of(mu, share < 0.5f ? 0.9f : 0.05f) > 10 * by_share);
  }
}

TEST_CASE("lobe choice: a polished coat's mean does not depend on it either") {
  const CoatFresnel fresnel{glass_index};
  const vec3 wo = slanting(75);
  const double expected = total_albedo(fresnel, reciprocal_base(Rgb(0.5f)), 0.0f, wo.z, 200);
  for (const float p : {0.1f, 0.5f, 0.9f}) {
    const PolishedDiffuse<ReciprocalBase, FixedChoice> bsdf{
        fresnel, reciprocal_base(Rgb(0.5f)), {p}};
    CHECK(weight_moments(bsdf, wo, 200).mean == close_to(expected, 5e-4));
  }
}
