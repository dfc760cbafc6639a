#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

glm::dvec3 half_vector(glm::dvec3 wo, glm::dvec3 wi) {
  const glm::dvec3 sum = wo + wi;
  const double length = glm::length(sum);
  if (length == 0.0) return glm::dvec3(0.0);
  return sum / length;
}

double ggx_eval(double alpha, const Fresnel& fresnel, glm::dvec3 wo, glm::dvec3 wi) {
  // Along the surface D and G are finite and a cosine is 0: ask before dividing.
  if (!(wo.z > 0.0 && wi.z > 0.0)) return 0.0;
  const glm::dvec3 h = half_vector(wo, wi);
  // The light meets a facet, not the surface: its angle is the one to h. wi makes the same with it.
  const double cosine = std::clamp(glm::dot(wo, h), 0.0, 1.0);
  const double facets = ggx_d(alpha, h) * smith_g2(alpha, wo, wi);
  return fresnel(cosine) * facets / (4.0 * wo.z * wi.z);
}

}  // namespace exercise
