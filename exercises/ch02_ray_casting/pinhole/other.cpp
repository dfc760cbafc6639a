// No cross product for up, and no pixel size: up is what remains of the given one without its
// part along the line of sight, and a ray aims between two corners of the window in the world.
#include "api.hpp"

#include <cmath>

namespace exercise {

Camera look_at(glm::vec3 position, glm::vec3 target, glm::vec3 up, float field_of_view) {
  Camera camera{};
  camera.position = position;
  camera.forward = (target - position) / glm::distance(target, position);
  camera.up = glm::normalize(up - glm::dot(up, camera.forward) * camera.forward);
  camera.right = glm::cross(camera.up, camera.forward);
  camera.field_of_view = field_of_view;
  return camera;
}

Ray camera_ray(const Camera& camera, glm::ivec2 pixel, glm::vec2 offset, int width, int height) {
  const float u = (static_cast<float>(pixel.x) + offset.x) / static_cast<float>(width);
  const float v = (static_cast<float>(pixel.y) + offset.y) / static_cast<float>(height);
  // As far away as makes half the window as wide as its sine: sin / cos is the tangent.
  const float half = 0.5f * camera.field_of_view;
  const glm::vec3 to_right = std::sin(half) * camera.right;
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const glm::vec3 to_top = std::sin(half) / aspect * camera.up;
  const glm::vec3 ahead = std::cos(half) * camera.forward;
  const glm::vec3 aim =
      glm::mix(ahead - to_right + to_top, ahead + to_right - to_top, glm::vec3(u, u, u));
  // Along the diagonal both move together; v moves the rest.
  return {camera.position, glm::normalize(aim - 2.0f * (v - u) * to_top)};
}

}  // namespace exercise
