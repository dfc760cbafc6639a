/// @file
/// A place to look at rough balls: under a sky that is known, so that nothing but the balls is
/// noisy.
#pragma once

#include <cmath>

#include "ch05_rendering_equation/traceable.hpp"
#include "ch08_microfacets/ball_row.hpp"

namespace lt {

// [sky]
/// A sky by formula: bright at the horizon, blue above, brown ground below, and a lamp.
struct Sky {
  Rgb zenith{0.10f, 0.22f, 0.50f};   ///< W/(m^2 sr), like the rest
  Rgb horizon{0.70f, 0.68f, 0.66f};  ///< seen from above it
  Rgb ground{0.20f, 0.17f, 0.14f};   ///< just below it
  Rgb nadir{0.10f, 0.08f, 0.06f};    ///< straight down
  Rgb lamp{6.0f, 5.5f, 5.0f};
  vec3 lamp_direction = normalize(vec3(-0.5f, 0.8f, -0.7f));  ///< towards its middle, world
  float lamp_cosine = 0.92f;  ///< of the angle from its middle to its rim; 1: no lamp

  /// @param direction  unit, world
  [[nodiscard]] Rgb radiance(vec3 direction) const {
    if (dot(direction, lamp_direction) > lamp_cosine) return lamp;
    const float up = direction.y;
    if (up < 0.0f) return glm::mix(ground, nadir, -up);
    return glm::mix(horizon, zenith, std::sqrt(up));
  }
};

/// The same everywhere: a ball that loses no light cannot be seen.
[[nodiscard]] inline Sky even_sky(Rgb radiance) {
  return {radiance, radiance, radiance, radiance, radiance};
}
// [sky]

// [studio]
/// Shapes with materials under a sky.
struct Studio {
  TexturedScene scene;
  Sky sky{};
};

[[nodiscard]] inline std::optional<Hit> closest_hit(const Studio& studio, const Ray& ray) {
  return closest_hit(studio.scene, ray);
}
[[nodiscard]] inline Surface surface_at(const Studio& studio, const Ray& ray, Hit hit) {
  return surface_at(studio.scene, ray, hit);
}
[[nodiscard]] inline Rgb background(const Studio& studio, vec3 direction) {
  return studio.sky.radiance(direction);
}
// [studio]

// [metal-floor]
/// Three matt balls on an endless floor of metal, seen from so low that the floor's facets hide
/// each other. No lamp.
/// @param metal  of the floor, with its roughness
[[nodiscard]] inline Studio metal_floor(const Material& metal) {
  Scene shapes;
  shapes.spheres = {
      {{-1.25f, 0.5f, 3.2f}, 0.5f}, {{0.1f, 0.6f, 4.6f}, 0.6f}, {{1.2f, 0.4f, 2.4f}, 0.4f}};
  shapes.grounds = {{0.0f}};
  Studio studio{TexturedScene(shapes), {.lamp_cosine = 1.0f}};
  std::vector<Look>& looks = studio.scene.looks;
  looks[0].material.tint = {0.75f, 0.15f, 0.10f};
  looks[1].material.tint = {0.80f, 0.78f, 0.74f};
  looks[2].material.tint = {0.10f, 0.25f, 0.60f};
  looks[3].material = metal;
  return studio;
}

[[nodiscard]] inline Camera metal_floor_camera() {
  Camera camera = look_at({0.0f, 0.5f, -2.5f}, {0.0f, 0.42f, 3.0f});
  camera.field_of_view = radians(34.0f);
  return camera;
}
// [metal-floor]

// [row-of]
/// Chapter 8's row of balls, all of one material but for the roughness.
[[nodiscard]] inline Studio row_of(Material material, const Sky& sky = {}) {
  Studio studio{TexturedScene(ball_row()), sky};
  for (int i = 0; i < row_count; ++i) {
    material.roughness = row_alphas[i];
    studio.scene.looks[static_cast<std::size_t>(i)].material = material;
  }
  return studio;
}
// [row-of]

}  // namespace lt
