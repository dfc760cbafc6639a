#include "ch10_dielectric/coated_bsdf.hpp"

#include "ch03_surfaces/three_sphere_room_surfaces.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "ch07_fresnel/tests/surface_of.hpp"
#include "ch10_dielectric/coat_tables.hpp"
#include "ch10_dielectric/tests/coats.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

template <class T>
bool is_a(const Material& material) {
  return std::holds_alternative<T>(coated_bsdf_at(surface_of(material)).kind);
}

const Material plaster{.tint = Rgb(0.4f), .specular = 0.2f, .roughness = 0.975f, .ior = 1.3f};

UnderSky ball_of(const Material& material) {
  UnderSky open{TexturedScene(Scene{{{vec3(0.0f), 1.0f}}, {}, {}}), Rgb(1.0f)};
  open.scene.looks[0].material = material;
  return open;
}

// A ray at the distance b from its axis meets the ball at the cosine sqrt(1 - b^2).
template <class Model>
RunningMean seen(const UnderSky& open, float b, const Model& bsdf_at) {
  const Ray ray{{b, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
  return many(ray, 20'000, [&](const Ray& r, Pcg32& random) {
    return radiance_recursive(open, bsdf_at, r, 1, random);
  });
}

}  // namespace

static_assert(Bsdf<CoatedBsdf<ReciprocalBase>> && Bsdf<CoatedBsdf<ConservingBase>>);

TEST_CASE(
    "coated at: opaque dielectrics wear a coat, rough or polished, and are matt without one") {
  CHECK(is_a<CoatedDiffuse<ReciprocalBase>>(plaster));
  CHECK(is_a<PolishedDiffuse<ReciprocalBase>>({.roughness = 0.0f}));
  CHECK(is_a<CosineLambert>({.specular = 0.0f}));
}

TEST_CASE("coated at: all others are chapter 9's") {
  CHECK(is_a<Glass>({.attenuation = Rgb(0.0f)}));
  CHECK(is_a<MetalReflection<>>(
      {.roughness = 0.1f, .ior = 0.277f, .extinction = 2.92f, .type = MaterialType::metal}));
  CHECK(is_a<Mirror>(
      {.roughness = 0.0f, .ior = 0.277f, .extinction = 2.92f, .type = MaterialType::metal}));
  CHECK(is_a<PlasticReflection<>>({.type = MaterialType::plastic}));
}

TEST_CASE("coated at: coat and base have what the material says") {
  const auto bsdf = coated_bsdf_at(surface_of(plaster));
  const auto& coat = std::get<CoatedDiffuse<ReciprocalBase>>(bsdf.kind);
  CHECK(coat.coat.ggx.alpha == 0.975f);
  CHECK(coat.base.albedo == Rgb(0.4f));
  // F at normal incidence is (0.3 / 2.3)^2, and a fifth of it is left.
  const double f = 0.2 * (0.3 / 2.3) * (0.3 / 2.3);
  CHECK(coat.coat.fresnel.share(1.0f) == close_to(f, 1e-7));
  const vec3 up(0, 0, 1);
  CHECK(coat.base.eval(up, up).g == close_to(0.4 * (1 - f) * (1 - f) / pi_, 1e-6));
}

TEST_CASE("coated at: a wall seen from behind has the same coat") {
  const auto front = coated_bsdf_at(surface_of(plaster));
  const auto back = coated_bsdf_at(surface_of(plaster, false));
  CHECK(front.eval(at_degrees(40), at_degrees(-50)) == back.eval(at_degrees(40), at_degrees(-50)));
}

TEST_CASE("coated at: a ball under an even sky is as bright as coat and base give back") {
  const Material floor{.tint = Rgb(0.6f), .specular = 0.45f, .roughness = 0.6f, .ior = 2.0f};
  const CoatFresnel coat = coat_of(floor);
  const UnderSky open = ball_of(floor);
  for (const float b : {0.0f, 0.6f, 0.95f}) {
    const float mu = std::sqrt(1 - b * b);
    const double expected = total_albedo(coat, ReciprocalBase{floor.tint, coat}, 0.6f, mu, 200);
    const RunningMean mean = seen(open, b, [](const Surface& s) { return coated_bsdf_at(s); });
    CHECK(z_test(mean, expected).agrees(2e-3));
  }
}

TEST_CASE("coated at: with conserving bases a white ball under an even sky cannot be seen") {
  for (const float roughness : {0.0f, 0.1f, 0.6f}) {
    const UnderSky open = ball_of({.roughness = roughness});
    const ConservingScattering scatter{std::make_shared<const CoatTables>(open.scene)};
    for (const float b : {0.0f, 0.6f, 0.95f, 0.995f})
      CHECK(z_test(seen(open, b, scatter), 1.0).agrees(2e-3));
  }
}

TEST_CASE("coated at: the thesis' bases glow at the rim of a smooth white ball") {
  // Cosine 0.1: 1.4436 by quadrature, published.
  const UnderSky open = ball_of({.roughness = 0.0f});
  const RunningMean mean =
      seen(open, std::sqrt(0.99f), [](const Surface& s) { return thesis_bsdf_at(s); });
  CHECK(z_test(mean, 1.4436).agrees(2e-3));
}

TEST_CASE("coat tables: every coat of the room has one, and equal coats share it") {
  const TexturedScene scene = three_sphere_room_plain();
  const CoatTables tables(scene);
  const auto table_at = [&](std::uint32_t object) {
    return &tables.of(scene.looks[object].material);
  };
  CHECK(table_at(room::north_wall) == table_at(room::ceiling));
  CHECK(table_at(room::floor) != table_at(room::ceiling));
  const SpecularAlbedo floor(0.6f, 2.0f);
  CHECK(table_at(room::floor)->at(0.3f) == floor.at(0.3f));
  CHECK(table_at(room::light)->mean() != table_at(room::floor)->mean());
}
