/// @file
/// Textures from files.
#pragma once

#include <filesystem>
#include <memory>

#include "ch01_pixels/image_file.hpp"
#include "ch03_surfaces/textured_scene.hpp"

namespace lt {

// [load-color]
/// A picture of colors, PNG or JPEG. Its codes are sRGB: they are decoded to linear light.
/// @throws InputError  see read_pixels8()
[[nodiscard]] inline Texture load_color(const std::filesystem::path& path) {
  return std::make_shared<const Image>(from_codes(read_pixels8(path)));
}
// [load-color]

// [load-normals]
/// A normal map, PNG or JPEG. Its codes are numbers, not light: code / 255, nothing decoded.
/// @throws InputError  see read_pixels8()
[[nodiscard]] inline Texture load_normals(const std::filesystem::path& path) {
  const Pixels8 codes = read_pixels8(path);
  Image normals(codes.width, codes.height);
  const std::uint8_t* code = codes.rgb.data();
  for (int y = 0; y < codes.height; ++y)
    for (int x = 0; x < codes.width; ++x)
      for (int c = 0; c < 3; ++c)
        normals.at(x, y)[c] = static_cast<float>(*code++) / 255.0f;
  return std::make_shared<const Image>(std::move(normals));
}
// [load-normals]

}  // namespace lt
