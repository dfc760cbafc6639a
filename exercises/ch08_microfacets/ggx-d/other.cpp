// By slopes: a facet with the normal h leans by x / z and y / z. Slopes follow a bell of their own
// (Student's, with two degrees of freedom), and cos^4 turns an area of slopes into a solid angle.
#include "api.hpp"

#include <cmath>
#include <numbers>

namespace exercise {

float brushed_ggx_d(glm::vec2 alphas, glm::vec3 h) {
  if (h.z <= 0.0f) return 0.0f;
  const double z = h.z;
  const double x_slope = h.x / z / alphas.x;
  const double y_slope = h.y / z / alphas.y;
  const double squared = std::fma(x_slope, x_slope, y_slope * y_slope);
  const double density_of_slopes =
      std::pow(1.0 + squared, -2.0) * std::numbers::inv_pi / alphas.x / alphas.y;
  return static_cast<float>(density_of_slopes / std::pow(z, 4.0));
}

float ggx_d(float alpha, glm::vec3 h) {
  return brushed_ggx_d({alpha, alpha}, h);
}

float ggx_d_between(float alpha, glm::vec3 wo, glm::vec3 wi) {
  const glm::dvec3 sum = glm::dvec3(wo) + glm::dvec3(wi);
  const double length = glm::length(sum);
  return length > 1e-6 ? ggx_d(alpha, glm::vec3(sum / length)) : 0.0f;
}

}  // namespace exercise
