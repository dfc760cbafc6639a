/// @file
/// Cast concrete.
#pragma once

#include "ch03_surfaces/noise.hpp"
#include "ch03_surfaces/relief.hpp"

namespace lt {

// [concrete-size]
/// The boards against which the wall was cast. On 3 m: panels of 1.5 x 1 m.
namespace concrete_wall {
inline constexpr ivec2 panels{2, 3};   ///< across and down
inline constexpr float seam = 0.003f;  ///< half its width; unit here: the wall's side
inline constexpr float seam_depth = 0.0015f;
inline constexpr float tie_radius = 0.0085f;  ///< of the holes of the ties that held the boards
inline constexpr float tie_depth = 0.006f;
}  // namespace concrete_wall
// [concrete-size]

// [concrete-at]
/// One point of a wall of cast concrete, as the boards have left it.
inline PatternPoint concrete_at(vec2 uv) {
  using namespace concrete_wall;
  // Which panel, and where on it: from its top left corner, in sides of the wall.
  const GridPoint panel = on_grid(uv, panels);
  const vec2 side = 1.0f / vec2(panels);
  const vec2 on_panel = panel.within * side;

  // Seams at the panel's edges; ties at a quarter and three quarters of it, across and down.
  const vec2 to_edge = glm::min(on_panel, side - on_panel);
  const float seam_here = 1.0f - glm::smoothstep(0.0f, seam, glm::min(to_edge.x, to_edge.y));
  const float to_tie = glm::distance(to_edge, side / 4.0f);
  const float tie_here = 1.0f - glm::smoothstep(0.6f * tie_radius, tie_radius, to_tie);

  // What the pour did: clouds, streaks down the boards, sand, and bubbles of air.
  const float clouds = fbm(uv, {3, 3}, 6, 100);
  const float streaks = fbm(uv, {40, 2}, 3, 110);
  const float sand = fbm(uv, {128, 128}, 2, 120);
  const float bubbles = glm::max(pits(uv, {96, 96}, 0.12f, 130), pits(uv, {48, 48}, 0.06f, 140));

  // Color: each panel its own grey; holes are dark, seams a little.
  const float batch = cell_random(panel.cell.x, panel.cell.y, 150) - 0.5f;
  float grey = 0.68f * (1.0f + 0.12f * batch + 0.7f * clouds + 0.25f * streaks + 0.3f * sand);
  grey *= 1.0f - 0.25f * seam_here;
  grey *= 1.0f - 0.55f * tie_here;
  grey *= 1.0f - 0.6f * bubbles;
  const Rgb color =
      grey * glm::mix(Rgb(1.03f, 1.0f, 0.95f), Rgb(0.98f, 1.0f, 1.02f), 0.5f + clouds);

  const float height = 0.004f * clouds + 0.0004f * sand - 0.002f * bubbles -
                       seam_depth * seam_here - tie_depth * tie_here;
  return {color, height};
}
// [concrete-at]

/// The concrete wall as colour and normal map.
/// @param size  texels along each side
[[nodiscard]] inline TextureMaps concrete(int size) {
  return paint(concrete_at, size);
}

}  // namespace lt
