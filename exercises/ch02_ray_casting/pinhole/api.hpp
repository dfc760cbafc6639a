/// @file
/// Exercise 02.1: what you write and what the checker calls.
#pragma once

#include <glm/glm.hpp>

#include "common/testkit/not_written.hpp"

namespace exercise {

struct Ray {
  glm::vec3 origin;
  glm::vec3 direction;  ///< unit
};

/// A pinhole. Its axes are unit and perpendicular, and lie to each other as x, y and z of the
/// left-handed world: x right, y up, z into the picture.
struct Camera {
  glm::vec3 position;
  glm::vec3 right;
  glm::vec3 up;
  glm::vec3 forward;    ///< into the picture
  float field_of_view;  ///< horizontal, radians: from the left edge of the picture to the right
};

/// A camera at `position` that sees `target` in the middle of its picture.
/// @param up  roughly upward: unit, not along the line of sight
[[nodiscard]] Camera look_at(glm::vec3 position, glm::vec3 target, glm::vec3 up,
                             float field_of_view);

/// The ray through a point of a pixel.
/// @param pixel   column and row; (0, 0) is at the top left
/// @param offset  where in the pixel, 0 to 1 from its top left corner; its middle is (0.5, 0.5)
/// @param width, height  of the picture in pixels, which are square
[[nodiscard]] Ray camera_ray(const Camera& camera, glm::ivec2 pixel, glm::vec2 offset, int width,
                             int height);

}  // namespace exercise
