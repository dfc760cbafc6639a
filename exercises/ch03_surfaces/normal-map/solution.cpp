#include "api.hpp"

#include <cmath>

namespace exercise {

Frame frame_around(glm::dvec3 normal) {
  // Duff et al. 2017. The sign chooses between two formulas: each divides by zero at one pole, and
  // each is used only in the other hemisphere.
  const double s = std::copysign(1.0, normal.z);
  const double a = -1.0 / (s + normal.z);
  const double b = normal.x * normal.y * a;
  const glm::dvec3 tangent(1.0 + s * normal.x * normal.x * a, s * b, -s * normal.x);
  return {tangent, glm::cross(normal, tangent), normal};
}

glm::dvec3 bumped_normal(const Frame& frame, glm::ivec3 code) {
  // Numbers, not light: no sRGB curve here. 0..255 to 0..1 to -1..1.
  const glm::dvec3 texel = glm::dvec3(code) / 255.0;
  const glm::dvec3 local = 2.0 * texel - 1.0;
  const glm::dvec3 world =
      local.x * frame.tangent + local.y * frame.bitangent + local.z * frame.normal;
  return glm::normalize(world);  // 8 bits round, and a mean of unit vectors is shorter than 1
}

}  // namespace exercise
