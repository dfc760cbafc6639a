#include "ch08_microfacets/rough_room.hpp"

#include "ch05_rendering_equation/tests/scenes.hpp"
#include "ch07_fresnel/tests/surface_of.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

TEST_CASE("rough room: metals are rough, clear things are glass, and the rest is matt") {
  const auto metal = rough_metal_at(surface_of({.tint = Rgb(0.5f),
                                                .roughness = 0.3f,
                                                .ior = 0.277f,
                                                .extinction = 2.92f,
                                                .type = MaterialType::metal}));
  const auto* rough = std::get_if<RoughMetal>(&metal.kind);
  REQUIRE(rough);
  CHECK(rough->ggx.alpha == 0.3f);
  CHECK(rough->fresnel(1.0f) == close_to(Rgb(0.5f * 0.890914f), 1e-6));  // chapter 7's gold
  const auto clear = rough_metal_at(surface_of({.attenuation = Rgb(0.0f)}, false));
  REQUIRE(std::holds_alternative<Glass>(clear.kind));
  CHECK(std::get<Glass>(clear.kind).n_here == 1.5f);  // seen from inside
  CHECK(std::holds_alternative<CosineLambert>(rough_metal_at(surface_of({})).kind));
}

TEST_CASE("rough room: only the metal ball gets its roughness") {
  const TexturedScene room = rough_room(16, 0.7f);
  CHECK(room.looks[room::gold_sphere].material.roughness == 0.7f);
  CHECK(room.looks[room::green_sphere].material.roughness == 0.1f);
  CHECK(room.looks[room::clear_sphere].material.ior == 1.5f);
}

TEST_CASE("rough room: no sample of it is negative, infinite or NaN") {
  const std::atomic<bool> never{false};
  for (const float roughness : {0.0f, 0.1f, 1.0f}) {
    const TexturedScene list = rough_room(16, roughness);
    const PackedScene room(list);
    Film film(50, 40);
    const auto estimate = [&](const Ray& ray, Pcg32& random) {
      const auto bsdf_at = [](const Surface& surface) { return rough_metal_at(surface); };
      return radiance_recursive(room, bsdf_at, ray, 8, random);
    };
    render(film, room_camera_far(), estimate, {.last = 32}, never);
    CHECK(summary(film).bad == 0);
  }
}
