#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

std::optional<Sample> ggx_sample(double alpha, const Fresnel& fresnel, glm::dvec3 wo,
                                 glm::dvec2 u) {
  const glm::dvec3 h = sample_facet(alpha, u);
  const double cosine = glm::dot(wo, h);
  const glm::dvec3 wi = 2.0 * cosine * h - wo;
  // This light is lost. Another try would bring it back, and more than there was.
  if (wi.z <= 0.0) return std::nullopt;
  const double pdf = ggx_d(alpha, h) * h.z / (4.0 * cosine);
  // f cos / pdf = F D G / (4 wo.z wi.z) * wi.z / (D h.z / (4 cosine)): D, 4 and wi.z cancel. What
  // is left holds where D is huge, or its quotient 0 / 0.
  const double share = fresnel(std::min(1.0, cosine));
  const double weight = share * smith_g2(alpha, wo, wi) * cosine / (wo.z * h.z);
  return Sample{wi, weight, pdf};
}

}  // namespace exercise
