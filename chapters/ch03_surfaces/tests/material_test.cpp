// The room's materials are the thesis', number by number; source: the thesis' published program.
#include "ch03_surfaces/material.hpp"

#include "ch03_surfaces/three_sphere_room_surfaces.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

void check_same(const Material& material, const Material& expected) {
  CHECK(material.emission == expected.emission);
  CHECK(material.tint == expected.tint);
  CHECK(material.specular == expected.specular);
  CHECK(material.roughness == expected.roughness);
  CHECK(material.ior == expected.ior);
  CHECK(material.attenuation == expected.attenuation);
  CHECK(material.extinction == expected.extinction);
  CHECK(material.type == expected.type);
}

constexpr auto dielectric = MaterialType::dielectric;

}  // namespace

TEST_CASE("materials: the room's spheres have the thesis' numbers") {
  const TexturedScene scene = three_sphere_room_plain();
  const auto material = [&](std::uint32_t object) { return scene.looks[object].material; };
  // emission, tint, specular, roughness, ior, attenuation, k, type
  check_same(material(room::light),
             {{45, 40, 30}, Rgb(1), 0.5f, 0.6f, 1.6f, Rgb(500), 0, dielectric});
  check_same(material(room::clear_sphere),
             {Rgb(0), Rgb(0), 0.8f, 0.002f, 1.04f, {0, 1, 0.666f}, 0, dielectric});
  check_same(material(room::gold_sphere), {Rgb(0),
                                           {1, 0.851246f, 0.301305f},
                                           0.8f,
                                           0.1f,
                                           0.277f,
                                           Rgb(500),
                                           2.92f,
                                           MaterialType::metal});
  check_same(
      material(room::green_sphere),
      {Rgb(0), {0.31627f, 0.95295f, 0.56719f}, 0.85f, 0.1f, 3, Rgb(500), 0, MaterialType::plastic});
}

TEST_CASE("materials: the room's walls and ground have the thesis' numbers") {
  const TexturedScene scene = three_sphere_room_plain();
  const auto wall = [](Rgb tint) {
    return Material{Rgb(0), tint, 0.2f, 0.975f, 1.3f, Rgb(500), 0, dielectric};
  };
  for (const std::uint32_t half : {0U, 1U}) {
    check_same(scene.looks[room::north_wall + half].material, wall({0.3f, 0.2f, 0.2f}));
    check_same(scene.looks[room::west_wall + half].material, wall({0.2f, 0.4f, 0.4f}));
    check_same(scene.looks[room::east_wall + half].material, wall({0.4f, 0.2f, 0.4f}));
    check_same(scene.looks[room::ceiling + half].material, wall({0.3f, 0.3f, 0.3f}));
  }
  check_same(scene.looks[room::floor].material,
             {Rgb(0), Rgb(0.6f), 0.45f, 0.6f, 2, Rgb(500), 0, dielectric});
  CHECK(scene.ground_mappings.at(0).texture_scalar == 1.0f);
}

TEST_CASE("materials: walls and ground wear textures with relief, spheres do not") {
  const TexturedScene scene = three_sphere_room_textured(16);
  for (std::uint32_t object = 0; object < scene.looks.size(); ++object) {
    CAPTURE(object);
    const bool is_sphere = object < room::north_wall;
    CHECK((scene.looks[object].color == nullptr) == is_sphere);
    CHECK((scene.looks[object].normals == nullptr) == is_sphere);
  }
  // One picture in memory for all concrete, another for the bricks.
  CHECK(scene.looks[room::west_wall].color == scene.looks[room::ceiling].color);
  CHECK(scene.looks[room::west_wall].color != scene.looks[room::north_wall].color);
}

TEST_CASE("materials: of the room's objects only the clear sphere lets light through") {
  const TexturedScene scene = three_sphere_room_plain();
  for (std::uint32_t object = 0; object < scene.looks.size(); ++object)
    CHECK(is_opaque(scene.looks[object].material) == (object != room::clear_sphere));
}

TEST_CASE("materials: one clear channel is enough to be clear, and only dielectrics are") {
  CHECK(is_opaque(Material{.attenuation = {500, 500, 500}}));
  CHECK_FALSE(is_opaque(Material{.attenuation = {500, 499, 500}}));
  CHECK(is_opaque(Material{.attenuation = Rgb(0.0f), .type = MaterialType::metal}));
  CHECK(is_opaque(Material{.attenuation = Rgb(0.0f), .type = MaterialType::plastic}));
}

TEST_CASE("materials: of the room's objects only the light sends light out") {
  const TexturedScene scene = three_sphere_room_plain();
  for (std::uint32_t object = 0; object < scene.looks.size(); ++object)
    CHECK(is_emissive(scene.looks[object].material) == (object == room::light));
}
