// As it is written: the BRDF, the cosine and the density, each by itself, and one division.
#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

std::optional<Sample> ggx_sample(double alpha, const Fresnel& fresnel, glm::dvec3 wo,
                                 glm::dvec2 u) {
  const glm::dvec3 facet = sample_facet(alpha, u);
  const double along = glm::dot(facet, wo);
  if (!(along > 0.0)) return std::nullopt;
  const glm::dvec3 wi = glm::normalize(wo + 2.0 * (along * facet - wo));
  if (!(wi.z > 0.0)) return std::nullopt;
  const glm::dvec3 h = glm::normalize(wo + wi);
  const double cosine = std::clamp(glm::dot(wi, h), 0.0, 1.0);
  const double f =
      fresnel(cosine) * ggx_d(alpha, h) * smith_g2(alpha, wo, wi) / (4.0 * wo.z * wi.z);
  const double pdf = ggx_d(alpha, h) * h.z / (4.0 * cosine);
  return Sample{wi, f * wi.z / pdf, pdf};
}

}  // namespace exercise
