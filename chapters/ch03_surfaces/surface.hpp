/// @file
/// Everything that shading wants to know about the winner of closest_hit().
#pragma once

#include "ch02_ray_casting/surface_point.hpp"
#include "ch03_surfaces/normal_map.hpp"
#include "ch03_surfaces/texture.hpp"
#include "ch03_surfaces/textured_scene.hpp"

namespace lt {

// [surface]
/// The surface where a ray met it.
struct Surface {
  SurfacePoint point;  ///< position and geometric normal, which points outward
  bool outside;        ///< the ray came from the side to which the geometric normal points
  Frame frame;         ///< its normal is the *shading* normal, on the side from which the ray came;
                       ///< its tangent follows the texture; any tangent if there is none
  vec2 uv;             ///< place on the texture, u right, v down; (0, 0) if there is none
  Material material;   ///< with the texel applied
};
// [surface]

/// Where the winner's texture has been hit.
[[nodiscard]] inline TexturePoint texture_point(const TexturedScene& scene, std::uint32_t object,
                                                const SurfacePoint& point) {
  const Scene& shapes = scene.shapes;
  std::size_t i = object;
  if (i < shapes.spheres.size()) return texture_point(scene.sphere_mappings[i], point.normal);
  i -= shapes.spheres.size();
  if (i < shapes.triangles.size())
    return texture_point(scene.triangle_mappings[i], shapes.triangles[i], point.position);
  return texture_point(scene.ground_mappings[i - shapes.triangles.size()], point.position);
}

// [surface-at]
/// Looks the winner's surface up: once per ray, never in the search.
[[nodiscard]] inline Surface surface_at(const TexturedScene& scene, const Ray& ray, Hit hit) {
  const Look& look = scene.looks[hit.object];
  const SurfacePoint point = surface_point(scene.shapes, ray, hit);
  Surface surface{point, dot(ray.direction, point.normal) < 0.0f, frame_around(point.normal),
                  vec2(0.0f), look.material};

  // Only who wears a texture needs a place on it: on a sphere that costs an atan2 and an acos.
  if (look.color || look.normals) {
    const TexturePoint on_texture = texture_point(scene, hit.object, point);
    surface.frame = frame_along(point.normal, on_texture.tangent);
    surface.uv = on_texture.uv;
  }
  if (look.color) {
    const Rgb texel = bilinear(*look.color, surface.uv);
    surface.material.tint *= texel;
    surface.material.emission *= texel;
  }
  // Bumps are laid on from outside: who looks from inside sees a bump as a dent.
  const vec3 wo = surface.outside ? -ray.direction : ray.direction;
  if (look.normals) surface.frame = bumped(surface.frame, bilinear(*look.normals, surface.uv), wo);
  if (!surface.outside) surface.frame = seen_from_behind(surface.frame);
  return surface;
}
// [surface-at]

}  // namespace lt
