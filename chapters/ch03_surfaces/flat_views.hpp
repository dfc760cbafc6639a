/// @file
/// Textures as flat pictures: the patterns with their normal maps, and one looked up in three ways.
#pragma once

#include <array>
#include <string_view>

#include "ch01_pixels/halve.hpp"
#include "ch01_pixels/paint.hpp"
#include "ch02_ray_casting/views.hpp"
#include "ch03_surfaces/bricks.hpp"
#include "ch03_surfaces/concrete.hpp"
#include "ch03_surfaces/mistakes.hpp"
#include "ch03_surfaces/planks.hpp"
#include "ch03_surfaces/tiles.hpp"

namespace lt {

/// A corner of each of the four patterns, colors above, normals (as codes) below.
[[nodiscard]] inline Image pattern_sheet(int texels, int width, int height) {
  const std::array<TextureMaps, 4> maps{bricks(texels), concrete(texels), tiles(texels),
                                        planks(texels)};
  const vec2 cell = 4.0f * vec2(width, height) / vec2(maps.size(), 2);  // painted 4 times as large
  return halve(halve(paint(4 * width, 4 * height, [&](vec2 p) {
    const vec2 in_cells = p / cell;
    const TextureMaps& shown = maps[static_cast<std::size_t>(in_cells.x)];
    // A part of each, as high and as wide as a cell: three bricks across.
    const vec2 uv = 0.4f * glm::fract(in_cells) * vec2(1.0f, cell.y / cell.x);
    return in_cells.y < 1.0f ? bilinear(shown.color, uv) : as_code(bilinear(shown.normals, uv));
  })));
}

/// A letter in 8 x 8 texels that looks different from every side.
[[nodiscard]] inline Image letter() {
  constexpr std::array<std::string_view, 8> rows{"........", ".aaaaa..", ".ab.....", ".ab.....",
                                                 ".aaaa...", ".ab.....", ".ab.....", "........"};
  Image texture(8, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const char c = rows[y][x];
      texture.at(x, y) = c == 'a'   ? Rgb(0.80f, 0.30f, 0.05f)
                         : c == 'b' ? Rgb(0.45f, 0.10f, 0.10f)
                                    : Rgb(0.03f, 0.08f, 0.20f);
    }
  return texture;
}

/// letter() enlarged: the nearest texel; bilinear; bilinear, shifted by half a texel. Fine lines
/// show where the texels' squares end.
[[nodiscard]] inline Image filter_strip(int width, int height) {
  const Image texture = letter();
  const float side = static_cast<float>(width) / 3.0f;
  return paint(width, height, [&](vec2 p) {
    const int panel = static_cast<int>(p.x / side);
    const vec2 uv((p.x - static_cast<float>(panel) * side) / side, p.y / side);
    const Rgb color = panel == 0   ? nearest(texture, uv)
                      : panel == 1 ? bilinear(texture, uv)
                                   : mistakes::bilinear_from_corners(texture, uv);
    const vec2 to_line = glm::abs(glm::fract(8.0f * uv + 0.5f) - 0.5f) * side / 8.0f;  // pixels
    return glm::min(to_line.x, to_line.y) < 0.6f ? color * 0.6f : color;
  });
}

}  // namespace lt
