/// @file
/// What the chapter's pictures show: the room, a globe, balls in a row.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "ch03_surfaces/headlight.hpp"
#include "ch03_surfaces/planks.hpp"
#include "ch03_surfaces/three_sphere_room_surfaces.hpp"
#include "ch03_surfaces/world_map.hpp"

namespace lt {

/// A scene, the light, and from where to look.
struct Exhibit {
  TexturedScene scene;
  Camera camera;
  Headlight lamp;
};

// [globe-rotation]
/// The Earth's rotation: spun about its own axis first, then tilted by 23.4 degrees as on a desk.
/// @param eastward  radians, from the position with Greenwich in front
[[nodiscard]] inline glm::quat globe_rotation(float eastward) {
  const glm::quat spin = rotation_about({0.0f, 1.0f, 0.0f}, -eastward);
  const glm::quat tilt = rotation_about({0.0f, 0.0f, 1.0f}, radians(-23.4f));
  return tilt * spin;  // the right one first
}
// [globe-rotation]

// [room-with-globe]
/// The textured room. The clear sphere reflects nothing diffusely: under a headlight it would be a
/// black ball. Until glass is taught, a globe stands in its place.
/// @param texels  side of the walls' textures
/// @param world   equirectangular map; null leaves the black ball
[[nodiscard]] inline Exhibit room_exhibit(const Camera& camera, int texels, Texture world,
                                          float eastward) {
  Exhibit room{three_sphere_room_textured(texels), camera, {1.9f, 5.2f}};
  if (world) {
    room.scene.looks[room::clear_sphere] = {Material{.tint = Rgb(0.9f)}, std::move(world), {}};
    room.scene.sphere_mappings[room::clear_sphere].rotation = globe_rotation(eastward);
  }
  return room;
}
// [room-with-globe]

/// Balls of radius 1 beside each other, one for each mapping, all with one look.
/// @param aspect  width / height of the picture that they are to fill
[[nodiscard]] inline Exhibit ball_row(const Look& look, const std::vector<SphereMapping>& balls,
                                      float aspect) {
  const float spacing = 2.2f;
  const float distance = 40.0f;  // from far away, so that the outer ones look like balls too
  Scene shapes;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const float x = spacing * (static_cast<float>(i) - static_cast<float>(balls.size() - 1) / 2);
    shapes.spheres.push_back({{x, 0.0f, 0.0f}, 1.0f});
  }
  Exhibit row{TexturedScene(shapes), look_at({0.0f, 0.0f, -distance}, vec3(0.0f)), {}};
  const float half_width = spacing / 2 * std::max(static_cast<float>(balls.size()), aspect);
  row.camera.field_of_view = 2.0f * std::atan(half_width / distance);
  std::fill(row.scene.looks.begin(), row.scene.looks.end(), look);
  row.scene.sphere_mappings = balls;
  return row;
}

/// Globes, turned eastwards by equal steps all the way round.
[[nodiscard]] inline Exhibit globes(int count, Texture world, float eastward, float aspect) {
  std::vector<SphereMapping> balls(count);
  for (int i = 0; i < count; ++i)
    balls[i].rotation = globe_rotation(eastward + 2.0f * pi * i / count);
  return ball_row({Material{}, std::move(world), {}}, balls, aspect);
}

/// What brick balls wear.
[[nodiscard]] inline Look brick_look(int texels) {
  Look look;
  wear(look, std::make_shared<const TextureMaps>(bricks(texels)));
  return look;
}

/// Brick balls, turned eastwards by equal steps to half a turn.
[[nodiscard]] inline Exhibit brick_balls(int count, int texels, float aspect) {
  std::vector<SphereMapping> balls(count);
  for (int i = 0; i < count; ++i) {
    balls[i].corner2 = {2.0f, 1.0f};
    balls[i].rotation = globe_rotation(pi * i / count);
  }
  return ball_row(brick_look(texels), balls, aspect);
}

/// Brick balls: from the front; from behind, where the texture's ends meet and do not fit; from
/// above.
[[nodiscard]] inline Exhibit seam_and_pole(int texels, float aspect) {
  std::vector<SphereMapping> balls(3);
  for (SphereMapping& ball : balls)
    ball.corner2 = {1.8f, 1.0f};
  balls[1].rotation = rotation_about({0.0f, 1.0f, 0.0f}, pi);
  balls[2].rotation = rotation_about({1.0f, 0.0f, 0.0f}, radians(-70.0f));
  return ball_row(brick_look(texels), balls, aspect);
}

}  // namespace lt
