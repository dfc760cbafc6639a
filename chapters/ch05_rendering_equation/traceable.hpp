/// @file
/// What a scene must answer before light can be traced through it.
#pragma once

#include <concepts>
#include <optional>

#include "ch03_surfaces/surface.hpp"

namespace lt {

// [textured-scene-traceable]
[[nodiscard]] inline std::optional<Hit> closest_hit(const TexturedScene& scene, const Ray& ray) {
  return closest_hit(scene.shapes, ray);
}

/// Radiance from where no object is: none, the room stands in the dark.
[[nodiscard]] inline Rgb background(const TexturedScene&, vec3 /*direction*/) {
  return Rgb(0.0f);
}
// [textured-scene-traceable]

// [traceable]
/// Three questions. Whoever answers them can be traced: a list of shapes, a tree of a million
/// triangles, or a formula.
template <class T>
concept Traceable = requires(const T& scene, const Ray& ray, Hit hit, vec3 direction) {
  { closest_hit(scene, ray) } -> std::same_as<std::optional<Hit>>;
  { surface_at(scene, ray, hit) } -> std::same_as<Surface>;
  { background(scene, direction) } -> std::same_as<Rgb>;
};
// [traceable]

}  // namespace lt
