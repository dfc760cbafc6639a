// The frame by the axis that is farthest from the normal; the normal by a matrix, made unit while
// it is still in local coordinates.
#include "api.hpp"

#include <cmath>

namespace exercise {

Frame frame_around(glm::dvec3 normal) {
  const glm::dvec3 size = glm::abs(normal);
  glm::dvec3 axis(0.0);
  if (size.x <= size.y && size.x <= size.z)
    axis.x = 1.0;
  else if (size.y <= size.z)
    axis.y = 1.0;
  else
    axis.z = 1.0;
  const glm::dvec3 bitangent = glm::normalize(glm::cross(normal, axis));
  return {glm::cross(bitangent, normal), bitangent, normal};
}

glm::dvec3 bumped_normal(const Frame& frame, glm::ivec3 code) {
  const glm::dvec3 local = glm::normalize(glm::dvec3(2 * code - 255));
  return glm::dmat3(frame.tangent, frame.bitangent, frame.normal) * local;
}

}  // namespace exercise
