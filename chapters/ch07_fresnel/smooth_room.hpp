/// @file
/// Two places to look at mirrors and glass.
#pragma once

#include "ch03_surfaces/three_sphere_room_surfaces.hpp"
#include "ch05_rendering_equation/lit_room.hpp"

namespace lt {

// [smooth-room]
/// The three-sphere room, whose clear sphere is glass at last. The thesis gives it an index
/// of 1.04, hardly more than air's; here one may choose.
/// @param texels  side of the walls' textures
/// @param ior     index of refraction of the clear sphere, > 0
[[nodiscard]] inline TexturedScene smooth_room(int texels, float ior) {
  TexturedScene scene = three_sphere_room_textured(texels);
  scene.looks[room::clear_sphere].material.ior = ior;
  return scene;
}
// [smooth-room]

/// A window onto the clear sphere, and one onto the metal one.
[[nodiscard]] inline Camera glass_camera() {
  Camera camera = look_at({1.5f, 1.2f, -1.4f}, {1.5f, 0.68f, 1.5f});
  camera.field_of_view = radians(34.0f);
  return camera;
}
[[nodiscard]] inline Camera metal_camera() {
  Camera camera = look_at({1.5f, 1.5f, -2.064f}, {0.5f, 0.45f, 2.1f});
  camera.field_of_view = radians(14.0f);
  return camera;
}

// [flooded-room]
/// The room, 1.2 m deep in still water that goes on in front of it. Mirrors and the clear sphere
/// are left out: they would have to know that they are in water. The matt ball lies half in it.
/// @param ior  index of refraction of the water, > 0
[[nodiscard]] inline TexturedScene flooded_room(int texels, float ior) {
  TexturedScene scene = smooth_room(texels, ior);
  Scene& shapes = scene.shapes;
  const Material water{.tint = Rgb(0.0f), .ior = ior, .attenuation = Rgb(0.0f)};
  shapes.spheres[room::clear_sphere] = {{0.0f, -9.0f, 0.0f}, 1.0f};  // out of sight
  shapes.spheres[room::gold_sphere] = {{0.0f, -9.0f, 0.0f}, 1.0f};
  shapes.spheres[room::green_sphere] = {{2.2f, 1.25f, 2.1f}, 0.45f};
  add_wall(shapes, {-20.0f, 1.2f, 3.0f}, {43.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -23.0f});
  // The new triangles come before the floor, which is the last object.
  scene.looks.insert(scene.looks.end() - 1, 2, Look{water, {}, {}});
  scene.triangle_mappings.resize(shapes.triangles.size());
  return scene;
}

/// Under water, near the floor, looking up and to the back.
[[nodiscard]] inline Camera diver_camera() {
  Camera camera = look_at({1.5f, 0.25f, 0.5f}, {1.5f, 1.25f, 1.35f});
  camera.field_of_view = radians(110.0f);
  return camera;
}
// [flooded-room]

}  // namespace lt
