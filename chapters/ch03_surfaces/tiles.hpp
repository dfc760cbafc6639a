/// @file
/// A tiled floor.
#pragma once

#include "ch03_surfaces/noise.hpp"
#include "ch03_surfaces/relief.hpp"

namespace lt {

// [tile-size]
/// On 1 m: stoneware tiles of 25 x 25 cm with their grout.
namespace tiled_floor {
inline constexpr int per_side = 4;      ///< tiles
inline constexpr float grout = 0.022f;  ///< its width; unit here: a tile's side
inline constexpr float bevel = 0.03f;   ///< width of a tile's round edge, the same unit
inline constexpr float depth = 0.003f;  ///< of the grout under the tiles' faces, in squares
}  // namespace tiled_floor
// [tile-size]

// [tile-at]
/// One point of a tiled floor.
inline PatternPoint tiles_at(vec2 uv) {
  using namespace tiled_floor;
  // Which tile, and how far from its edge.
  const GridPoint tile = on_grid(uv, ivec2(per_side));
  const vec2 on_tile = tile.within - 0.5f;
  const float inside = -round_box(on_tile, vec2(1.0f - grout) / 2.0f, 0.03f);
  const float glazed = glm::smoothstep(-0.004f, 0.004f, inside);

  // Sand, and clouds cut differently for each tile; no kiln repeats a shade.
  const auto luck = [&](int draw) { return cell_random(tile.cell.x, tile.cell.y, 200 + draw); };
  const vec2 cut(luck(0), luck(1));
  const float clouds = fbm(uv + cut, {8, 8}, 5, 210);
  const float sand = fbm(uv, {128, 128}, 2, 220);
  const float shade = 0.74f + 0.16f * (luck(2) - 0.5f) + 0.25f * clouds + 0.12f * sand;
  const Rgb glaze = shade * glm::mix(Rgb(1.05f, 1.0f, 0.93f), Rgb(0.99f, 1.0f, 1.0f), luck(3));

  // The grout is rough and darker.
  const Rgb grout_color = Rgb(0.36f, 0.34f, 0.32f) * (1.0f + 0.8f * sand);

  // Round edges; not quite level, not quite even.
  const float rim = glm::clamp(inside / bevel, 0.0f, 1.0f);
  const float round = std::sqrt(rim * (2.0f - rim));
  const vec2 tilt = vec2(luck(4), luck(5)) - 0.5f;
  const float waves = fbm(uv + cut, {8, 8}, 2, 240);
  const float height = depth * round + glazed * (0.003f * dot(tilt, on_tile) + 0.0012f * waves) +
                       (1.0f - glazed) * 0.0006f * sand;
  return {glm::mix(grout_color, glaze, glazed), height};
}
// [tile-at]

/// The tiled floor as colour and normal map.
/// @param size  texels along each side
[[nodiscard]] inline TextureMaps tiles(int size) {
  return paint(tiles_at, size);
}

}  // namespace lt
