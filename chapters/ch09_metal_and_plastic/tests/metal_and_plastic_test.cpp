#include "ch09_metal_and_plastic/metal_and_plastic.hpp"

#include "ch03_surfaces/three_sphere_room_surfaces.hpp"
#include "ch04_monte_carlo/pcg32.hpp"
#include "ch07_fresnel/tests/surface_of.hpp"
#include "ch08_microfacets/albedo.hpp"
#include "ch09_metal_and_plastic/all_normals.hpp"
#include "ch09_metal_and_plastic/rough.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const vec3 above(0, 0, 1);

Material gold_of_the_thesis() {
  return three_sphere_room_plain().looks[room::gold_sphere].material;
}
Material green_of_the_thesis() {
  return three_sphere_room_plain().looks[room::green_sphere].material;
}
Material with_roughness(Material material, float roughness) {
  material.roughness = roughness;
  return material;
}
template <class T>
bool is_a(const Material& material) {
  return std::holds_alternative<T>(rough_bsdf_at(surface_of(material)).kind);
}

Rgb mean_weight(const auto& bsdf, vec3 wo, int count) {
  Pcg32 random(1);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < count; ++i)
    if (const auto sample = bsdf.sample(wo, random.next_vec3())) sum += glm::dvec3(sample->weight);
  return Rgb(sum / double(count));
}

}  // namespace

static_assert(Bsdf<RoughBsdf<>>);
static_assert(Bsdf<RoughBsdf<AllNormals>>);

TEST_CASE("metal: the thesis' gold straight on reflects 0.8909 of its tint") {
  // Fresnel for 0.277 + 2.92 i at 0 degrees, computed independently: 0.890914.
  const auto sample = metal_of(gold_of_the_thesis()).sample(above, {0.3f, 0.0f, 0.0f});
  REQUIRE(sample->wi == above);  // u.y = 0 makes h = z
  CHECK(sample->weight == close_to(0.890914f * Rgb(1.0f, 0.851246f, 0.301305f), 1e-3));
}

TEST_CASE("plastic: the thesis' green straight on reflects a quarter of its tint") {
  // ((3 - 1) / (3 + 1))^2 = 1/4.
  const auto sample = plastic_of(green_of_the_thesis()).sample(above, {0.3f, 0.0f, 0.0f});
  CHECK(sample->weight == close_to(0.25f * Rgb(0.31627f, 0.95295f, 0.56719f), 1e-3));
}

TEST_CASE("plastic: of index 1.5 it gives back next to nothing, as was computed elsewhere") {
  // alpha 0.3, separable masking: 0.0356 of the tint from above, 0.135 at cosine 0.1.
  const RoughReflection<TintedFresnel, VisibleNormals, g2_separable> half{
      {0.3f}, {{1.0f, 1.5f}, Rgb(0.5f)}};
  CHECK(mean_weight(half, above, 400'000).g == Approx(0.5 * 0.0356).epsilon(5e-3));
  CHECK(mean_weight(half, at_cosine(0.1f), 400'000).g == Approx(0.5 * 0.135).epsilon(1e-2));
}

TEST_CASE("metal: Fresnel's cosine is the one to the facet, not to the surface") {
  // From 10 and to 80 degrees in one plane the facet's angle is 45: 0.888388, both ways. At the
  // surface it would be 0.89091 one way and 0.91528 the other.
  const MetalReflection<> grey = metal_of(
      {.roughness = 0.5f, .ior = 0.277f, .extinction = 2.92f, .type = MaterialType::metal});
  const MicrofacetReflection white{grey.ggx, PerfectMirror{}};
  const vec3 steep(std::sin(radians(10)), 0.0f, std::cos(radians(10)));
  const vec3 flat(-std::sin(radians(80)), 0.0f, std::cos(radians(80)));
  for (const auto& [wo, wi] : {std::pair{steep, flat}, std::pair{flat, steep}})
    CHECK(grey.eval(wo, wi).g / white.eval(wo, wi).g == close_to(0.888388f, 1e-5));
}

TEST_CASE("metal and plastic: sample, eval and pdf belong together, in colour") {
  Pcg32 random(2);
  for (const float mu : {1.0f, 0.5f, 0.1f}) {
    CHECK(triple_complaint(metal_of(gold_of_the_thesis()), at_cosine(mu), 5000, random) == "");
    CHECK(triple_complaint(plastic_of<AllNormals>(green_of_the_thesis()), at_cosine(mu), 5000,
                           random) == "");
  }
}

TEST_CASE("polished: metal and plastic become mirrors that reflect what Fresnel's equations say") {
  const vec3 wo = at_cosine(0.5f);
  const Mirror plastic = polished_of(with_roughness(green_of_the_thesis(), 0.0f));
  const auto sample = plastic.sample(wo, vec3(0.5f));
  const float share = fresnel_dielectric(0.5f, 1.0f, 3.0f);
  CHECK(sample->weight == close_to(share * Rgb(0.31627f, 0.95295f, 0.56719f), 1e-5));
  const Mirror metal = polished_of(gold_of_the_thesis());
  CHECK(metal.sample(above, vec3(0.5f))->weight.r == close_to(0.890914f, 1e-5));
}

TEST_CASE("polished: at the border the rough surface gives back what the mirror does") {
  for (const float mu : {1.0f, 0.5f, 0.1f}) {
    const Material border = with_roughness(gold_of_the_thesis(), smallest_alpha);
    REQUIRE_FALSE(is_polished(border));
    const vec3 wo = at_cosine(mu);
    const Rgb mirror = polished_of(border).sample(wo, vec3(0.5f))->weight;
    CHECK(mean_weight(metal_of(border), wo, 100'000) == close_to(mirror, 1e-3));
  }
}

TEST_CASE("rough: every material is what it says, as far as the course has come") {
  CHECK(is_a<MetalReflection<>>(gold_of_the_thesis()));
  CHECK(is_a<PlasticReflection<>>(green_of_the_thesis()));
  CHECK(is_a<Mirror>(with_roughness(gold_of_the_thesis(), 0.0009f)));
  CHECK(is_a<Mirror>(with_roughness(green_of_the_thesis(), 0.0f)));
  CHECK(is_a<Glass>({.attenuation = Rgb(0.0f)}));
  CHECK(is_a<CosineLambert>({}));
}
