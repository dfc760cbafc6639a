#include "api.hpp"

#include <cmath>

namespace exercise {

Camera look_at(glm::vec3 position, glm::vec3 target, glm::vec3 up, float field_of_view) {
  const glm::vec3 forward = glm::normalize(target - position);
  // As x = y x z. The cross product of two slanted unit vectors is shorter than 1.
  const glm::vec3 right = glm::normalize(glm::cross(up, forward));
  const glm::vec3 upright = glm::cross(forward, right);  // as y = z x x; `up` itself may lean
  return {position, right, upright, forward, field_of_view};
}

Ray camera_ray(const Camera& camera, glm::ivec2 pixel, glm::vec2 offset, int width, int height) {
  const glm::vec2 film = glm::vec2(pixel) + offset;  // from the top left corner, in pixels
  // The picture is a window at distance 1; half of it fills half of the field of view. Pixels are
  // square, so that one step serves both directions.
  const float half_width = std::tan(camera.field_of_view / 2.0f);
  const glm::vec2 step(2.0f * half_width / static_cast<float>(width));
  const float x = (film.x - static_cast<float>(width) / 2.0f) * step.x;
  const float y = (static_cast<float>(height) / 2.0f - film.y) * step.y;  // rows go down, y up
  const glm::vec3 direction = x * camera.right + y * camera.up + camera.forward;
  return {camera.position, glm::normalize(direction)};
}

}  // namespace exercise
