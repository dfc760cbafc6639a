// What each mistake does, in numbers; and which test would not have seen it.
#include "ch10_dielectric/mistakes.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch10_dielectric/choice_price.hpp"
#include "ch10_dielectric/tests/coats.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const Material white_glossy{.tint = Rgb(1.0f), .roughness = 0.1f, .ior = 1.5f};

template <class Coated>
std::string triple(const Coated& bsdf) {
  Pcg32 random(1);
  return triple_complaint(bsdf, slanting(60), 2'000, random);
}

template <class Coated>
SamplerReport report_on(const Coated& bsdf, vec3 wo) {
  Pcg32 random(1);
  const auto draw = [&]() -> std::optional<vec3> {
    const auto sample = bsdf.sample(wo, random.next_vec3());
    return sample ? std::optional(sample->wi) : std::nullopt;
  };
  const DirectionBins bins(24, 32, RowSpacing::equal_angle);
  // A sampler that reports the density of the base alone would have to follow it.
  return test_sampler(draw, [&](vec3 wi) { return double{cosine_hemisphere_pdf(wi.z)}; },
                      {20'000, bins});
}

WeightMoments moments(const auto& bsdf, float mu) {
  return weight_moments(bsdf, at_cosine(mu), 300);
}

}  // namespace

TEST_CASE("mistakes: a base that is not attenuated gives back E too much, from everywhere") {
  const auto wrong = mistakes::bare_base_of(white_glossy);
  for (const float mu : {1.0f, 0.5f, 0.1f})
    CHECK(moments(wrong, mu).mean == close_to(1.0 + double{table_of(0.1f).at(mu)}, 2e-3));
}

TEST_CASE("mistakes: a base that is not attenuated is reciprocal, and its parts fit together") {
  const auto wrong = mistakes::bare_base_of(white_glossy);
  CHECK(triple(wrong) == "");
  const vec3 a = slanting(20), b = at_degrees(-70);
  CHECK(wrong.eval(a, b).g == Approx(wrong.eval(b, a).g).epsilon(1e-5));
}

TEST_CASE("mistakes: divided by the density of the chosen lobe the mean is right") {
  const auto right = mistakes::right_coat_of(white_glossy);
  const auto wrong = mistakes::density_of_chosen_of(white_glossy);
  for (const float mu : {1.0f, 0.5f}) {
    RunningMean mean;
    Pcg32 random(2);
    for (int i = 0; i < 200'000; ++i) {
      const auto sample = wrong.sample(at_cosine(mu), random.next_vec3());
      mean.add(sample ? double{sample->weight.g} : 0.0);
    }
    CHECK(z_test(mean, moments(right, mu).mean).agrees(0.02));
  }
}

TEST_CASE("mistakes: divided by the density of the chosen lobe there are fireflies") {
  // Straight on, the base chosen: f_s cos / p_d = pi F D / 4 = 0.04 / (4 alpha^2) = 1, added to
  // 0.9. From 60 degrees the coat's lobe is higher still; chosen well, no weight is above 1.1.
  const auto wrong = mistakes::density_of_chosen_of(white_glossy);
  const auto right = mistakes::right_coat_of(white_glossy);
  for (const float mu : {0.5f, 0.3f})
    CHECK(moments(wrong, mu).variance > 30 * moments(right, mu).variance);
}

TEST_CASE("mistakes: the triple sees the density of the chosen lobe") {
  CHECK(triple(mistakes::right_coat_of(white_glossy)) == "");
  CHECK(triple(mistakes::density_of_chosen_of(white_glossy)) != "");
}

TEST_CASE(
    "mistakes: chi-square sees it too, if the density of one lobe is taken for that of both") {
  CHECK(report_on(mistakes::density_of_chosen_of(white_glossy), at_degrees(60)).complaint != "");
}

TEST_CASE("mistakes: not divided by p the sum of both lobes becomes their mean") {
  // p E + (1 - p) times what the base gives back.
  const auto wrong = mistakes::not_divided_of(white_glossy);
  for (const float mu : {1.0f, 0.5f, 0.1f}) {
    const double p = wrong.coat_probability(at_cosine(mu));
    const double coat = table_of(0.1f).at(mu);
    const double base = base_albedo(wrong.base, at_cosine(mu), 200);
    CHECK(moments(wrong, mu).mean == close_to(p * coat + (1 - p) * base, 2e-3));
  }
  CHECK(moments(wrong, 0.1f).mean <
        0.6 * moments(mistakes::right_coat_of(white_glossy), 0.1f).mean);
}

TEST_CASE("mistakes: not divided by p, light goes both ways alike, and the triple complains") {
  const auto wrong = mistakes::not_divided_of(white_glossy);
  const vec3 a = slanting(20), b = at_degrees(-70);
  CHECK(wrong.eval(a, b).g == Approx(wrong.eval(b, a).g).epsilon(1e-5));
  CHECK(triple(wrong) != "");
}

TEST_CASE("mistakes: each leaves metal, plastic and glass alone") {
  const auto scatter = mistakes::with_coat(mistakes::bare_base_of);
  Surface surface{};
  surface.outside = true;
  surface.material = {.roughness = 0.2f, .type = MaterialType::plastic};
  const vec3 wo = slanting(30), wi = at_degrees(-30);
  CHECK(scatter(surface).eval(wo, wi) == rough_bsdf_at(surface).eval(wo, wi));
  surface.material = white_glossy;
  CHECK(scatter(surface).eval(wo, wi) == mistakes::bare_base_of(white_glossy).eval(wo, wi));
}
