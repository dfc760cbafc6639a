/// @file
/// The pinhole camera.
#pragma once

#include <cassert>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "ch02_ray_casting/ray.hpp"

namespace lt {

// [camera]
/// A pinhole at `position` that looks along `forward`. The three axes are unit and perpendicular;
/// the world is left-handed: x right, y up, z into the picture.
struct Camera {
  vec3 position{0.0f};
  vec3 right{1.0f, 0.0f, 0.0f};
  vec3 up{0.0f, 1.0f, 0.0f};
  vec3 forward{0.0f, 0.0f, 1.0f};
  float field_of_view = radians(72.0f);  ///< horizontal, radians, 0 to pi (both excluded)
};
// [camera]

// [look-at]
/// A camera at `position` that sees `target` in the middle of its picture.
/// @param target  not at `position`
/// @param up      roughly upward; not along the line of sight
[[nodiscard]] inline Camera look_at(vec3 position, vec3 target, vec3 up = {0.0f, 1.0f, 0.0f}) {
  assert(length(cross(up, target - position)) > 0.0f);
  Camera camera;
  camera.position = position;
  camera.forward = normalize(target - position);
  camera.right = normalize(cross(up, camera.forward));
  camera.up = cross(camera.forward, camera.right);
  return camera;
}
// [look-at]

// [oriented]
/// A camera at `position`, turned by `orientation` (unit quaternion) from looking along +z.
[[nodiscard]] inline Camera oriented(vec3 position, glm::quat orientation) {
  Camera camera;
  camera.position = position;
  camera.right = orientation * camera.right;
  camera.up = orientation * camera.up;
  camera.forward = orientation * camera.forward;
  return camera;
}
// [oriented]

// [camera-ray]
/// The ray through a point of the picture.
/// @param film   in pixels from the top left corner: the middle of pixel (x, y) is (x+.5, y+.5)
/// @param width, height  of the picture in pixels
[[nodiscard]] inline Ray camera_ray(const Camera& camera, vec2 film, int width, int height) {
  // The picture as a window at distance 1, from -half_width to half_width.
  const float half_width = std::tan(camera.field_of_view / 2.0f);
  const float pixel = 2.0f * half_width / static_cast<float>(width);
  const float x = (film.x - static_cast<float>(width) / 2.0f) * pixel;
  const float y = (static_cast<float>(height) / 2.0f - film.y) * pixel;  // rows go down, y goes up
  return {camera.position, normalize(x * camera.right + y * camera.up + camera.forward)};
}
// [camera-ray]

}  // namespace lt
