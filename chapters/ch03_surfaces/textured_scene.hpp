/// @file
/// Shapes, and beside them, under the same numbers, how they look.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "ch02_ray_casting/scene.hpp"
#include "ch03_surfaces/material.hpp"
#include "ch03_surfaces/texture_maps.hpp"
#include "ch03_surfaces/uv.hpp"

namespace lt {

/// A picture that several objects may wear; none where it is null.
using Texture = std::shared_ptr<const Image>;

// [look]
/// What an object looks like.
struct Look {
  Material material;
  Texture color;    ///< linear, 0 to 1; multiplies the material's tint and emission
  Texture normals;  ///< see decode_normal()
};
// [look]

// [textured-scene]
/// A scene with the look of each object and the way in which its texture lies on it.
struct TexturedScene {
  Scene shapes;
  std::vector<Look> looks;                         ///< by object number
  std::vector<SphereMapping> sphere_mappings;      ///< as shapes.spheres
  std::vector<TriangleMapping> triangle_mappings;  ///< as shapes.triangles
  std::vector<GroundMapping> ground_mappings;      ///< as shapes.grounds

  TexturedScene() = default;
  /// Every object gets the standard look and mapping.
  explicit TexturedScene(Scene scene)
      : shapes(std::move(scene)),
        looks(shapes.object_count()),
        sphere_mappings(shapes.spheres.size()),
        triangle_mappings(shapes.triangles.size()),
        ground_mappings(shapes.grounds.size()) {}
};
// [textured-scene]

// [wear]
/// Hangs both pictures of `maps` on an object.
inline void wear(Look& look, const std::shared_ptr<const TextureMaps>& maps) {
  look.color = Texture(maps, &maps->color);  // shares the maps, points at one picture
  look.normals = Texture(maps, &maps->normals);
}
// [wear]

// [map-wall]
/// Lays a texture over a wall that was added by add_wall().
/// @param wall     object number of the first of its two triangles
/// @param repeats  how many times the texture fits into the wall, to the right and down, > 0
inline void map_wall(TexturedScene& scene, std::uint32_t wall, vec2 repeats = vec2(1.0f)) {
  const std::size_t first = wall - scene.shapes.spheres.size();
  const vec2 top_left(0.0f), top_right(repeats.x, 0.0f), bottom_left(0.0f, repeats.y);
  scene.triangle_mappings.at(first) = {{top_left, top_right, repeats}};
  scene.triangle_mappings.at(first + 1) = {{top_left, repeats, bottom_left}};
}
// [map-wall]

}  // namespace lt
