/// @file
/// The three-sphere room with the thesis' materials and textures.
#pragma once

#include "ch02_ray_casting/three_sphere_room.hpp"
#include "ch03_surfaces/bricks.hpp"
#include "ch03_surfaces/concrete.hpp"
#include "ch03_surfaces/textured_scene.hpp"
#include "ch03_surfaces/tiles.hpp"

namespace lt {

// [room-materials]
/// The room with its materials and no textures; numbers from the thesis' program.
[[nodiscard]] inline TexturedScene three_sphere_room_plain() {
  TexturedScene scene(three_sphere_room());
  const auto dress = [&](std::uint32_t object, const Material& material) {
    scene.looks[object].material = material;
  };
  const auto dress_wall = [&](std::uint32_t wall, Rgb tint) {
    const Material plaster{.tint = tint, .specular = 0.2f, .roughness = 0.975f, .ior = 1.3f};
    dress(wall, plaster);
    dress(wall + 1, plaster);
    map_wall(scene, wall);
  };
  dress(room::light, {.emission = {45, 40, 30}, .specular = 0.5f, .roughness = 0.6f, .ior = 1.6f});
  dress(room::clear_sphere, {.tint = Rgb(0.0f),
                             .specular = 0.8f,
                             .roughness = 0.002f,
                             .ior = 1.04f,
                             .attenuation = {0.0f, 1.0f, 0.666f}});
  dress(room::gold_sphere, {.tint = {1.0f, 0.851246f, 0.301305f},
                            .specular = 0.8f,
                            .roughness = 0.1f,
                            .ior = 0.277f,
                            .extinction = 2.92f,
                            .type = MaterialType::metal});
  dress(room::green_sphere, {.tint = {0.31627f, 0.95295f, 0.56719f},
                             .specular = 0.85f,
                             .roughness = 0.1f,
                             .ior = 3.0f,
                             .type = MaterialType::plastic});
  dress_wall(room::north_wall, {0.3f, 0.2f, 0.2f});
  dress_wall(room::west_wall, {0.2f, 0.4f, 0.4f});
  dress_wall(room::east_wall, {0.4f, 0.2f, 0.4f});
  dress_wall(room::ceiling, {0.3f, 0.3f, 0.3f});
  dress(room::floor, {.tint = Rgb(0.6f), .specular = 0.45f, .roughness = 0.6f, .ior = 2.0f});
  return scene;
}
// [room-materials]

// [room-textures]
/// The room with materials and textures: bricks in the north, concrete at the sides and above,
/// tiles on the floor.
/// @param texels  side of each texture, >= 1
[[nodiscard]] inline TexturedScene three_sphere_room_textured(int texels = 512) {
  TexturedScene scene = three_sphere_room_plain();
  const auto cover = [&](std::uint32_t wall, const std::shared_ptr<const TextureMaps>& maps) {
    wear(scene.looks[wall], maps);
    wear(scene.looks[wall + 1], maps);
  };
  const auto cast = std::make_shared<const TextureMaps>(concrete(texels));
  cover(room::north_wall, std::make_shared<const TextureMaps>(bricks(texels)));
  cover(room::west_wall, cast);
  cover(room::east_wall, cast);
  cover(room::ceiling, cast);
  wear(scene.looks[room::floor], std::make_shared<const TextureMaps>(tiles(texels)));
  return scene;
}
// [room-textures]

}  // namespace lt
