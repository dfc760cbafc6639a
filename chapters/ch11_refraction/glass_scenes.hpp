/// @file
/// Places to look at clear objects: the complete room, rows of glass balls, a lamp in glass.
#pragma once

#include "ch07_fresnel/smooth_room.hpp"
#include "ch09_metal_and_plastic/studio.hpp"

namespace lt {

// [complete-room]
/// What the room's clear sphere is of. The thesis' numbers: hardly denser than air, as good as
/// polished, and a pink that takes no red away.
struct ClearSphere {
  float ior = 1.04f;         ///< index of refraction, > 0
  float roughness = 0.002f;  ///< 0 to 1
  float colour = 1.0f;       ///< factor on the attenuation, >= 0
};

/// The thesis' three-sphere room with all of its materials and textures.
/// @param texels  side of the walls' textures
[[nodiscard]] inline TexturedScene complete_room(int texels, const ClearSphere& sphere = {}) {
  TexturedScene scene = three_sphere_room_textured(texels);
  Material& clear = scene.looks[room::clear_sphere].material;
  clear.ior = sphere.ior;
  clear.roughness = sphere.roughness;
  clear.attenuation *= sphere.colour;
  return scene;
}
// [complete-room]

/// Down onto the floor around the clear sphere.
[[nodiscard]] inline Camera caustic_camera() {
  Camera camera = look_at({1.5f, 1.1f, -1.2f}, {1.5f, 0.12f, 1.1f});
  camera.field_of_view = radians(38.0f);
  return camera;
}

// [glass-row]
/// Chapter 9's row with balls of glass, ever rougher.
[[nodiscard]] inline Studio glass_row(float ior, const Sky& sky = {}) {
  return row_of({.ior = ior, .attenuation = Rgb(0.0f)}, sky);
}
// [glass-row]

// [lamp-in-glass]
/// Two equal lamps, half as bright as white. One lies inside a ball of glass; where it is lit by
/// nothing else, a dim sky shows the ball.
[[nodiscard]] inline Studio lamp_in_glass(float ior) {
  const Material lamp{.emission = Rgb(0.5f), .tint = Rgb(0.0f), .specular = 0.0f};
  Scene shapes;
  shapes.spheres = {
      {{-1.2f, 0.0f, 0.0f}, 1.0f}, {{-1.2f, 0.0f, 0.0f}, 0.35f}, {{1.2f, 0.0f, 0.0f}, 0.35f}};
  Studio studio{TexturedScene(shapes), even_sky(Rgb(0.03f))};
  studio.scene.looks[0].material = {.roughness = 0.002f, .ior = ior, .attenuation = Rgb(0.0f)};
  studio.scene.looks[1].material = lamp;
  studio.scene.looks[2].material = lamp;
  return studio;
}

[[nodiscard]] inline Camera lamp_camera() {
  Camera camera = look_at({0.0f, 0.0f, -20.0f}, vec3(0.0f));
  camera.field_of_view = radians(13.5f);
  return camera;
}
// [lamp-in-glass]

}  // namespace lt
