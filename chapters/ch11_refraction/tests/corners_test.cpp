// A million evaluations where floats run out.
#include "ch11_refraction/media.hpp"
#include "ch11_refraction/tests/glasses.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

bool is_good(float f) {
  return std::isfinite(f) && f >= 0.0f;
}

template <Bsdf Any>
bool all_good(const Any& bsdf, vec3 wo, vec3 wi, vec3 u) {
  const auto sample = bsdf.sample(wo, u);
  return is_good(bsdf.eval(wo, wi).g) && is_good(bsdf.pdf(wo, wi)) &&
         (!sample || (std::abs(length(sample->wi) - 1.0f) < 1e-4f && is_good(sample->weight.g) &&
                      is_good(sample->pdf) && is_good(bsdf.eval(wo, sample->wi).g)));
}

}  // namespace

TEST_CASE("rough glass: a million corners, nothing is infinite or NaN or negative") {
  const float alphas[] = {1e-4f, 1e-3f, 0.002f, 0.1f, 1.0f};
  const float cosines[] = {1e-30f, 1e-15f, 1e-7f, 1e-4f, 0.1f, 0.5f, 1.0f - 0x1p-24f, 1.0f};
  const float numbers[] = {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, last};
  const float indices[] = {1.0f - 1e-6f, 1.0f + 1e-6f, 1.04f, 1.5f, 3.0f, 0.3f};
  Pcg32 random(1);
  const auto any_of = [&](const auto& list) { return list[random.next_bits() % std::size(list)]; };
  for (int i = 0; i < 500'000; ++i) {
    const float alpha = any_of(alphas), ior = any_of(indices);
    const vec3 wo = slanting_at(i % 3 ? any_of(cosines) : random.next_float());
    vec3 wi = slanting_at(any_of(cosines));
    if (i % 2) wi = vec3(-wi.x, -wi.y, wi.z);
    if (i % 4 < 2) wi.z = -wi.z;
    if (i % 7 == 0) wi = -wo;
    const float x = any_of(numbers), y = any_of(numbers);
    const vec3 u(x, y, any_of(numbers));
    CAPTURE(alpha, ior, wo.z, wi.x, wi.z, u.x, u.y, u.z);
    const auto check = [&](float here, float beyond) {
      const bool visible = all_good(RoughGlass<>{{alpha}, here, beyond}, wo, wi, u);
      if (!visible) REQUIRE(visible);
      const bool all = all_good(RoughGlass<AllNormals>{{alpha}, here, beyond}, wo, wi, u);
      if (!all) REQUIRE(all);
    };
    check(1.0f, ior);
    check(ior, 1.0f);
  }
}

TEST_CASE("media: at the ends of the range shares are 0 or 1 and never NaN") {
  CHECK(transmittance(Rgb(0.0f), 0.0f) == Rgb(1.0f));
  CHECK(transmittance(Rgb(0.0f), 1e30f) == Rgb(1.0f));
  CHECK(transmittance(Rgb(1e30f), 1e30f) == Rgb(0.0f));
  CHECK(transmittance(Rgb(1e30f), 0.0f) == Rgb(1.0f));
}
