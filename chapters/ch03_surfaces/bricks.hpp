/// @file
/// A brick wall.
#pragma once

#include "ch03_surfaces/noise.hpp"
#include "ch03_surfaces/relief.hpp"

namespace lt {

// [brick-size]
/// The wall's plan. On 3 m: bricks of 375 x 125 mm with their joints, somewhat larger than life
/// (215 x 65 mm), so that joints are still seen from across the room.
namespace brick_wall {
inline constexpr int courses = 24;       ///< rows
inline constexpr int per_course = 8;     ///< bricks
inline constexpr float joint = 0.13f;    ///< width of the mortar; unit here: height of a course
inline constexpr float depth = 0.0025f;  ///< of the mortar behind the bricks' faces, in squares
static_assert(courses % 2 == 0, "the last course must fit under the first one's shift");
}  // namespace brick_wall
// [brick-size]

// [brick-at]
// [brick-plan]
/// One point of a wall in running bond: each course is shifted by half a brick.
inline PatternPoint bricks_at(vec2 uv) {
  using namespace brick_wall;
  // No bricklayer is perfect: edges wander a little.
  const vec2 wander(fbm(uv, {12, 24}, 4, 10), fbm(uv, {12, 24}, 4, 20));
  const vec2 bent = uv + 0.006f * wander;

  // Which brick, and where on it, from its middle, in heights of a course.
  const ivec2 grid(per_course, courses);
  const bool odd = on_grid(bent, grid).cell.y % 2 == 1;
  const GridPoint brick = on_grid(bent + vec2(odd ? 0.5f / per_course : 0.0f, 0.0f), grid);
  const float aspect = static_cast<float>(courses) / per_course;
  const vec2 on_brick = (brick.within - 0.5f) * vec2(aspect, 1.0f);

  // 1 on the brick's face, 0 in the joint, round between.
  const vec2 half = (vec2(aspect, 1.0f) - joint) / 2.0f;
  const float grain = fbm(uv, {96, 96}, 2, 30);
  const float inside = 0.14f * grain - round_box(on_brick, half, 0.12f);
  const float face = glm::smoothstep(-0.04f, 0.14f, inside);

  // What the fire did to this brick: how light, how yellow, how it sits.
  const auto luck = [&](int draw) { return cell_random(brick.cell.x, brick.cell.y, draw); };
  const Rgb red(0.74f, 0.43f, 0.34f), straw(0.86f, 0.66f, 0.50f), plum(0.58f, 0.37f, 0.36f);
  Rgb color = glm::mix(red, luck(1) < 0.7f ? straw : plum, 0.8f * luck(2) * luck(2));
  color *= 0.85f + 0.25f * luck(3);
  const vec2 tilt = vec2(luck(4), luck(5)) - 0.5f;
  // [brick-plan]

  // Grain and pits, and the soot of years.
  const float pit = pits(uv, {110, 110}, 0.35f, 40);
  const float soot = fbm(uv, {3, 4}, 4, 50);
  const Rgb mortar = Rgb(0.82f, 0.79f, 0.74f) * (1.0f + 0.5f * grain);
  color = glm::mix(mortar, color * (1.0f + 0.6f * grain - 0.35f * pit),
                   glm::smoothstep(0.0f, 0.05f, inside));
  color *= 1.0f + 0.4f * soot;
  const float height =
      depth * face * (1.0f + 0.2f * dot(tilt, on_brick) - 0.3f * pit) + 0.0006f * grain;
  return {color, height};
}
// [brick-at]

/// The brick wall as colour and normal map.
/// @param size  texels along each side
[[nodiscard]] inline TextureMaps bricks(int size) {
  return paint(bricks_at, size);
}

}  // namespace lt
