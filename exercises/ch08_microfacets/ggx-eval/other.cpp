// The angle at the facet is half of the angle between the directions, and the facets' normal is
// the middle of the arc. The factors come one after the other.
#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

glm::dvec3 half_vector(glm::dvec3 wo, glm::dvec3 wi) {
  const glm::dvec3 middle = 0.5 * wi + 0.5 * wo;
  const double squared = glm::dot(middle, middle);
  return squared < 1e-30 ? glm::dvec3(0.0) : middle * (1.0 / std::sqrt(squared));
}

double ggx_eval(double alpha, const Fresnel& fresnel, glm::dvec3 wo, glm::dvec3 wi) {
  if (std::min(wo.z, wi.z) <= 0.0) return 0.0;
  const double cos_between = glm::dot(wo, wi);
  const double cos_half = std::sqrt(std::max(0.0, (1.0 + cos_between) / 2.0));
  double f = ggx_d(alpha, half_vector(wi, wo)) / 4.0;
  f *= smith_g2(alpha, wi, wo) / wo.z;
  f *= fresnel(std::min(1.0, cos_half)) / wi.z;
  return f;
}

}  // namespace exercise
