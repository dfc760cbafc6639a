#include "api.hpp"

#include <cmath>
#include <numbers>

namespace exercise {

namespace {

// GGX facets lean as those of half a ball that is flattened to the height alpha. Stretched back, z
// grows by 1 / alpha against x and y. A normal changes the other way round: of the ball's, x and y
// shrink by alpha where the ball is flattened. So one formula does both.
glm::dvec3 stretched(double alpha, glm::dvec3 v) {
  return glm::normalize(glm::dvec3(alpha * v.x, alpha * v.y, v.z));
}

}  // namespace

glm::dvec3 sample_visible(double alpha, glm::dvec3 wo, glm::dvec2 u) {
  const glm::dvec3 view = stretched(alpha, wo);
  // What one sees of a mirror ball sends the view evenly into all directions. What one sees of its
  // upper half sends it into those higher than -view.z. Even heights are even areas.
  const double z = (1.0 - u.y) * (1.0 + view.z) - view.z;
  const double radius = std::sqrt(std::fmax(0.0, 1.0 - z * z));
  const double phi = 2.0 * std::numbers::pi * u.x;
  const glm::dvec3 w(radius * std::cos(phi), radius * std::sin(phi), z);
  // The normal is half-way between the view and where it was mirrored to.
  return stretched(alpha, w + view);
}

double visible_pdf(double alpha, glm::dvec3 wo, glm::dvec3 h) {
  const double cosine = glm::dot(wo, h);
  if (cosine <= 0.0) return 0.0;
  // Area, as large as it looks, without what is hidden: in sum the surface as large as it looks.
  return smith_g1(alpha, wo) * ggx_d(alpha, h) * cosine / wo.z;
}

double visible_weight(double alpha, glm::dvec3 wo, glm::dvec3 wi) {
  // D G2 / (4 wo.z wi.z) * wi.z / (G1 D / (4 wo.z)): all but the two shares cancel.
  return smith_g2(alpha, wo, wi) / smith_g1(alpha, wo);
}

}  // namespace exercise
