// A million evaluations where floats run out.
#include <vector>

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch10_dielectric/tests/coats.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

constexpr float last = 1.0f - 0x1p-24f;

bool is_good(Rgb f) {
  return std::isfinite(f.r + f.g + f.b) && std::min({f.r, f.g, f.b}) >= 0.0f;
}

/// All of what can be asked of a BSDF.
template <Bsdf Any>
void require_good(const Any& bsdf, vec3 wo, vec3 wi, vec3 u) {
  REQUIRE(is_good(bsdf.eval(wo, wi)));
  REQUIRE(is_good(Rgb(bsdf.pdf(wo, wi))));
  if (const auto sample = bsdf.sample(wo, u)) {
    REQUIRE(is_good(sample->weight));
    REQUIRE(is_good(Rgb(sample->pdf)));
    REQUIRE(std::abs(length(sample->wi) - 1.0f) < 1e-4f);
  }
}

vec3 direction(float mu, float turn) {
  const float radius = std::sqrt((1 - mu) * (1 + mu));
  return {radius * std::cos(turn), radius * std::sin(turn), mu};
}

float corner_or_inner(Pcg32& random) {
  const float choice = random.next_float();
  return choice < 0.3f ? 0.0f : choice < 0.6f ? last : random.next_float();
}

}  // namespace

TEST_CASE("coats: a million evaluations at the corners are finite and not negative") {
  const std::vector<float> cosines{1.0f, 0.5f, 1e-2f, 1e-4f, 1e-7f, 1e-12f, 1e-18f, 1e-20f, 1e-44f};
  const std::vector<float> alphas{1e-4f, 1e-3f, 0.02f, 0.3f, 1.0f};
  const std::vector<float> indices{1.0f, 1.0f - 1e-6f, 1.0f + 1e-6f, 1.5f, 3.0f};
  const std::vector<Rgb> albedos{Rgb(0.0f), Rgb(1.0f), Rgb(0.0f, 0.3f, 1.0f)};
  Pcg32 random(4);
  const auto any_of = [&](const auto& values) {
    return values[random.next_bits() % values.size()];
  };
  const SpecularAlbedo& table = table_of(0.3f);
  for (int count = 0; count < 1'000'000; count += 3 * 4) {
    const float alpha = any_of(alphas);
    const float ior = any_of(indices);
    const CoatFresnel fresnel{ior, random.next_bits() % 4 == 0 ? 0.0f : 1.0f};
    const Rgb albedo = any_of(albedos);
    const float inner = 2 * pi * random.next_float();
    const float turn = random.next_bits() % 2 == 0 ? pi : inner;
    const vec3 wo = direction(any_of(cosines), 0.0f);
    const vec3 wi = direction(any_of(cosines), turn);
    const float x = corner_or_inner(random);
    const float y = corner_or_inner(random);
    const vec3 u(x, y, corner_or_inner(random));
    const Coat<> coat{{alpha}, fresnel};
    require_good(CoatedDiffuse<ThesisBase>{coat, {albedo, fresnel}}, wo, wi, u);
    require_good(CoatedDiffuse<ReciprocalBase>{coat, {albedo, fresnel}}, wo, wi, u);
    require_good(CoatedDiffuse<ConservingBase>{coat, {albedo, fresnel.specular, table}}, wo, wi, u);
    require_good(PolishedDiffuse<ReciprocalBase>{fresnel, {albedo, fresnel}}, wo, wi, u);
  }
}
