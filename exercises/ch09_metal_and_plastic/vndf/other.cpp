// By the picture of the half ball, which is one half disk and half an ellipse: a point of a disk,
// squeezed into it (Heitz 2018). And the weight by the quotient.
#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace exercise {

glm::dvec3 sample_visible(double alpha, glm::dvec3 wo, glm::dvec2 u) {
  const glm::dvec3 view = glm::normalize(glm::dvec3(alpha * wo.x, alpha * wo.y, wo.z));
  // Across the view: one axis level, one rising. Straight from above any level one will do.
  const double sine = std::hypot(view.x, view.y);
  const glm::dvec3 level =
      sine > 0.0 ? glm::dvec3(-view.y, view.x, 0.0) / sine : glm::dvec3(1, 0, 0);
  const glm::dvec3 rising = glm::cross(view, level);

  const double radius = std::sqrt(u.x);
  const double phi = 2.0 * std::numbers::pi * u.y;
  const double a = radius * std::cos(phi);
  // Of each chord, keep the share (1 + view.z) / 2 that the upper half of the ball shows.
  const double upper = (1.0 + view.z) / 2.0;
  const double b = std::lerp(std::sqrt(1.0 - a * a), radius * std::sin(phi), upper);
  const double towards = std::sqrt(std::max(0.0, 1.0 - a * a - b * b));
  const glm::dvec3 m = a * level + b * rising + towards * view;
  return glm::normalize(glm::dvec3(alpha * m.x, alpha * m.y, std::max(0.0, m.z)));
}

double visible_pdf(double alpha, glm::dvec3 wo, glm::dvec3 h) {
  return ggx_d(alpha, h) * std::max(0.0, glm::dot(wo, h)) / (wo.z / smith_g1(alpha, wo));
}

double visible_weight(double alpha, glm::dvec3 wo, glm::dvec3 wi) {
  if (!(wi.z > 0.0)) return 0.0;
  const glm::dvec3 h = glm::normalize(wo + wi);
  const double f = ggx_d(alpha, h) * smith_g2(alpha, wo, wi) / (4.0 * wo.z * wi.z);
  return f * wi.z / (visible_pdf(alpha, wo, h) / (4.0 * glm::dot(wo, h)));
}

}  // namespace exercise
