#include "ch04_monte_carlo/pcg32.hpp"
#include "ch10_dielectric/tests/coats.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

PolishedDiffuse<ReciprocalBase> polished(Rgb albedo) {
  return {{glass_index}, reciprocal_base(albedo)};
}

constexpr float last = 1.0f - 0x1p-24f;

}  // namespace

static_assert(Bsdf<PolishedDiffuse<ReciprocalBase>> && Bsdf<PolishedDiffuse<ConservingBase>>);

TEST_CASE("polished: the coat is a delta that pays for its own probability") {
  const auto bsdf = polished(Rgb(0.5f));
  const vec3 wo = slanting(60);
  const auto sample = bsdf.sample(wo, vec3(0.3f, 0.4f, 0.0f));
  REQUIRE(sample);
  CHECK(is_delta(*sample));
  CHECK(sample->wi == close_to(vec3(-wo.x, -wo.y, wo.z), 1e-6));
  CHECK(sample->weight.g * bsdf.coat_probability(wo) == close_to(0.0891867, 1e-6));
}

TEST_CASE("polished: the base is sampled as its density says, with what the coat leaves of 1") {
  const auto bsdf = polished(Rgb(0.2f, 0.5f, 0.8f));
  for (const float degrees : {0.0f, 60.0f, 85.0f}) {
    const vec3 wo = slanting(degrees);
    Pcg32 random(1);
    const auto draw = [&]() -> std::optional<vec3> {
      const auto sample = bsdf.sample(wo, random.next_vec3());
      if (!sample || is_delta(*sample)) return std::nullopt;  // no density finds a delta
      return sample->wi;
    };
    const auto report =
        test_sampler(draw, [&](vec3 wi) { return bsdf.pdf(wo, wi); }, {.samples = 100'000});
    CHECK(report.complaint == "");
    CHECK(report.integral == close_to(1.0 - double{bsdf.coat_probability(wo)}, 5e-4));
  }
}

TEST_CASE("polished: the base's weight times its density is f cos") {
  const auto bsdf = polished(Rgb(0.2f, 0.5f, 0.8f));
  const vec3 wo = slanting(70);
  Pcg32 random(2);
  for (int i = 0; i < 10'000; ++i) {
    const vec2 u = random.next_vec2();
    const auto sample = bsdf.sample(wo, vec3(u, last));
    REQUIRE(sample);
    const Rgb f_cos = bsdf.eval(wo, sample->wi) * sample->wi.z;
    REQUIRE(sample->weight * sample->pdf == close_to(f_cos, 1e-4 * length(f_cos)));
    REQUIRE(sample->pdf == close_to(bsdf.pdf(wo, sample->wi), 1e-5));
  }
}

TEST_CASE("polished: all samples together give F + albedo (1 - F)(1 - mean F)") {
  for (const float mu : {1.0f, 0.5f, 0.1f}) {
    Pcg32 random(3);
    RunningMean mean;
    for (int i = 0; i < 50'000; ++i)
      mean.add(polished(Rgb(0.5f)).sample(at_cosine(mu), random.next_vec3())->weight.g);
    const double f = fresnel_dielectric(double{mu}, 1.0, 1.5);
    CHECK(z_test(mean, f + 0.5 * (1 - f) * (1 - mean_fresnel(1.5))).agrees(1e-3));
  }
}

TEST_CASE("polished: a coat ever less rough becomes it") {
  // The same total; alpha 0.002 differs from a mirror by less than a thousandth from 60 degrees.
  const float mu = 0.5f;
  CHECK(white_total("reciprocal", 0.002f, mu, 200) ==
        close_to(white_total("reciprocal", 0.0f, mu, 200), 1e-3));
}

TEST_CASE("polished: nobody but the sampler meets the delta") {
  const auto bsdf = polished(Rgb(0.5f));
  const vec3 wo = slanting(30);
  const vec3 mirrored(-wo.x, -wo.y, wo.z);
  CHECK(bsdf.eval(wo, mirrored) == bsdf.base.eval(wo, mirrored));
  CHECK(bsdf.eval(wo, -wo) == Rgb(0.0f));
  CHECK(bsdf.pdf(wo, -wo) == 0.0f);
  CHECK_FALSE(bsdf.sample(-wo, vec3(0.5f)));
}
