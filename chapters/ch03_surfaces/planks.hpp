/// @file
/// Wooden planks.
#pragma once

#include "ch03_surfaces/noise.hpp"
#include "ch03_surfaces/relief.hpp"

namespace lt {

// [plank-size]
/// On 1 m: boards of 12.5 cm, 1 m long, along u, each shifted by its own amount.
namespace plank_floor {
inline constexpr int rows = 8;
inline constexpr int boards = 1;        ///< in each row
inline constexpr float gap = 0.02f;     ///< half its width; unit here: a board's width
inline constexpr float depth = 0.003f;  ///< of the gaps, in squares
}  // namespace plank_floor
// [plank-size]

// [plank-at]
/// One point of a floor of wooden boards.
inline PatternPoint planks_at(vec2 uv) {
  using namespace plank_floor;
  // Which board, and where on it, from its middle, in widths of a board.
  const ivec2 grid(boards, rows);
  const float shift = cell_random(0, on_grid(uv, grid).cell.y, 300);
  const GridPoint board = on_grid(uv + vec2(shift, 0.0f), grid);
  const float length = static_cast<float>(rows) / boards;
  const vec2 on_board = (board.within - 0.5f) * vec2(length, 1.0f);
  const auto luck = [&](int draw) { return cell_random(board.cell.x, board.cell.y, 310 + draw); };
  const vec2 to_edge = vec2(length, 1.0f) / 2.0f - glm::abs(on_board);
  const float wood_here = glm::smoothstep(0.3f * gap, gap, glm::min(to_edge.x, to_edge.y));

  // A board is a cut through a tree's years: far from the heart they are straight lines, which
  // wander, and which bend around a knot.
  const vec2 cut(luck(0), luck(1));
  const vec2 knot((luck(2) - 0.5f) * 0.8f * length, (luck(3) - 0.5f) * 0.8f);
  const vec2 from_knot = (on_board - knot) * vec2(0.5f, 1.0f);
  const float near_knot = luck(4) < 0.6f ? std::exp(-dot(from_knot, from_knot) / 0.012f) : 0.0f;
  const float heart = 2.0f * luck(5) - 1.0f;
  const float years = 7.0f * std::sqrt((on_board.y - heart) * (on_board.y - heart) + 0.02f) +
                      5.0f * fbm(uv + cut, {2, 12}, 3, 330) + 2.5f * near_knot;

  // Early wood is pale; it darkens towards the end of each year.
  const float year = years - std::floor(years);
  const float late =
      glm::smoothstep(0.1f, 0.85f, year) * (1.0f - glm::smoothstep(0.85f, 1.0f, year));
  const float fibers = fbm(uv + cut, {6, 160}, 2, 340);
  const Rgb pale(0.80f, 0.60f, 0.38f), dark(0.56f, 0.34f, 0.17f);
  Rgb color = glm::mix(pale, dark, 0.7f * late + 0.35f * near_knot) * (0.7f + 0.5f * luck(6));
  color *= 1.0f + 0.6f * fibers;
  color *= 1.0f - 0.6f * glm::smoothstep(0.6f, 0.9f, near_knot);
  color *= 0.25f + 0.75f * wood_here;

  const float height = depth * wood_here + 0.0004f * fibers - 0.0002f * late;
  return {color, height};
}
// [plank-at]

/// The planks as colour and normal map.
/// @param size  texels along each side
[[nodiscard]] inline TextureMaps planks(int size) {
  return paint(planks_at, size);
}

}  // namespace lt
