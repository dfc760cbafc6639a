/// @file
/// The three-sphere room for matt surfaces only.
#pragma once

#include <memory>
#include <string>

#include "ch03_surfaces/exhibits.hpp"
#include "ch05_rendering_equation/radiance.hpp"
#include "ch05_rendering_equation/uniform_lambert.hpp"

namespace lt {

// [matt-room]
/// The textured room for a renderer that knows matt surfaces only. Gold and green become chalk in
/// their colours. The clear sphere gives no light back where it is hit: as chalk it would be black,
/// so the globe of chapter 3 stays in its place until glass is taught.
/// @param texels  side of the walls' textures
[[nodiscard]] inline TexturedScene matt_room(int texels) {
  const auto world = std::make_shared<const Image>(world_map(2 * texels));
  return room_exhibit(room_camera_far(), texels, world, 0.0f).scene;
}
// [matt-room]

/// A window onto the floor between the globe and the gold ball, where a shadow, a wall and two
/// balls meet; for strips and measurements.
[[nodiscard]] inline Camera close_up_camera() {
  Camera camera = look_at({1.5f, 1.5f, -2.064f}, {0.72f, 0.4f, 1.8f});
  camera.field_of_view = radians(14.0f);
  return camera;
}

/// @param name  far, near or close: where to stand in the room
[[nodiscard]] inline Camera camera_named(const std::string& name) {
  if (name == "close") return close_up_camera();
  return name == "far" ? room_camera_far() : room_camera_near();
}

}  // namespace lt
