/// @file
/// A furnace: a closed room that glows all over, so that what one sees in it is known.
#pragma once

#include <cmath>
#include <optional>

#include "ch05_rendering_equation/traceable.hpp"

namespace lt {

// [hollow-sphere]
/// A scene of one formula: the inside of a sphere of 1 m around the origin, of one material. Its
/// outer side, the one that glows, faces the hollow.
struct HollowSphere {
  Material material;
  Sphere shape{vec3(0.0f), 1.0f};
};

[[nodiscard]] inline std::optional<Hit> closest_hit(const HollowSphere& scene, const Ray& ray) {
  const auto t = intersect(scene.shape, ray, infinity);
  return t ? std::optional(Hit{*t, 0}) : std::nullopt;
}

[[nodiscard]] inline Surface surface_at(const HollowSphere& scene, const Ray& ray, Hit hit) {
  SurfacePoint point = point_on(scene.shape, ray.at(hit.t));
  point.normal = -point.normal;
  return {point, true, frame_around(point.normal), vec2(0.0f), scene.material};
}

/// Nothing: there is no way out.
[[nodiscard]] inline Rgb background(const HollowSphere&, vec3 /*direction*/) {
  return Rgb(0.0f);
}
// [hollow-sphere]

// [furnace]
/// Radiance in a closed room that glows all over: Le (1 + a + a^2 + ... + a^depth).
/// @param emission  Le of every wall, W/(m^2 sr)
/// @param albedo    a of every wall, 0 to 1
/// @param depth     scattering events at most, >= 0
[[nodiscard]] inline double furnace_radiance(double emission, double albedo, int depth) {
  if (albedo == 1.0) return emission * (depth + 1);
  return emission * (1.0 - std::pow(albedo, depth + 1)) / (1.0 - albedo);
}
// [furnace]

}  // namespace lt
