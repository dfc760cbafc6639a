/// @file
/// Mistakes to look at. The pictures of `--wrong` are made with them; nothing else uses them.
#pragma once

#include <memory>
#include <utility>

#include "ch03_surfaces/surface.hpp"

namespace lt::mistakes {

// [not-decoded]
/// Takes a file's sRGB codes for light: texel = code / 255.
[[nodiscard]] inline Texture not_decoded(const Image& texture) {
  Image codes = texture;
  for (int y = 0; y < codes.height(); ++y)
    for (int x = 0; x < codes.width(); ++x)
      for (int c = 0; c < 3; ++c)
        codes.at(x, y)[c] = encode_srgb(texture.at(x, y)[c]);
  return std::make_shared<const Image>(std::move(codes));
}
// [not-decoded]

// [half-texel]
/// Takes the texels for points at the corners of a grid: everything moves by half a texel.
[[nodiscard]] inline Rgb bilinear_from_corners(const Image& texture, vec2 uv) {
  const vec2 size(texture.width(), texture.height());
  return bilinear(texture, uv + 0.5f / size);
}
// [half-texel]

// [local-normals]
/// Leaves a rotated sphere's shading normal in the sphere's own axes, as the thesis' program does.
[[nodiscard]] inline Surface surface_with_local_normal(const TexturedScene& scene, const Ray& ray,
                                                       Hit hit) {
  Surface surface = surface_at(scene, ray, hit);
  if (scene.looks[hit.object].normals && hit.object < scene.shapes.spheres.size()) {
    const glm::quat rotation = scene.sphere_mappings[hit.object].rotation;
    surface.frame.normal = rotate_back(rotation, surface.frame.normal);
  }
  return surface;
}
// [local-normals]

}  // namespace lt::mistakes
