/// @file
/// The three-sphere room: the course's running example, with the thesis' numbers.
#pragma once

#include "ch02_ray_casting/camera.hpp"
#include "ch02_ray_casting/scene.hpp"

namespace lt {

/// Adds a parallelogram as two triangles. The normal points to the side from which `right` goes
/// right and `down` goes down.
/// @param top_left  a corner
/// @param right, down  the edges from that corner, metres
inline void add_wall(Scene& scene, vec3 top_left, vec3 right, vec3 down) {
  const vec3 bottom_right = top_left + right + down;
  scene.triangles.emplace_back(top_left, top_left + right, bottom_right);
  scene.triangles.emplace_back(top_left, bottom_right, top_left + down);
}

// [room]
/// The numbers of the room's objects. A wall is two triangles: its number and the next.
namespace room {
enum Object : std::uint32_t {
  light,
  clear_sphere,
  gold_sphere,
  green_sphere,  // spheres
  north_wall,
  west_wall = north_wall + 2,
  east_wall = west_wall + 2,
  ceiling = east_wall + 2,
  floor = ceiling + 2
};
}  // namespace room

/// Three spheres and a sphere light in a room of 3 x 3 x 3 metres, open towards the camera.
[[nodiscard]] inline Scene three_sphere_room() {
  Scene scene;
  scene.spheres = {{{1.5f, 3.0f, 1.5f}, 0.5f},         // light, half of it above the ceiling
                   {{1.5f, 0.7f, 1.5f}, 0.7f},         // clear
                   {{0.5f, 0.45f, 2.1f}, 0.45f},       // gold
                   {{2.5f, 0.45f, 2.1f}, 0.45f}};      // green
  add_wall(scene, {0, 3, 3}, {3, 0, 0}, {0, -3, 0});   // north, z = 3
  add_wall(scene, {0, 3, 0}, {0, 0, 3}, {0, -3, 0});   // west, x = 0
  add_wall(scene, {3, 3, 3}, {0, 0, -3}, {0, -3, 0});  // east, x = 3
  add_wall(scene, {0, 3, 0}, {3, 0, 0}, {0, 0, 3});    // ceiling, y = 3
  scene.grounds = {{0.0f}};
  return scene;
}

/// The thesis' two places for the camera: near, low between the spheres; far, the whole room.
[[nodiscard]] inline Camera room_camera_near() {
  return look_at({1.5f, 0.5f, -0.5f}, {1.5f, 0.5f, 1.5f});
}
[[nodiscard]] inline Camera room_camera_far() {
  return look_at({1.5f, 1.5f, -2.064f}, {1.5f, 1.5f, 1.5f});
}
// [room]

}  // namespace lt
