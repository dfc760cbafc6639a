#include "api.hpp"

#include <cmath>
#include <numbers>

namespace exercise {

using std::numbers::pi;

double eval(const CoatedBase& material, glm::dvec3 wo, glm::dvec3 wi) {
  if (wo.z <= 0.0 || wi.z <= 0.0) return 0.0;
  // The base gets what the coat lets in, and of what it sends back, sees out what the coat lets
  // out.
  const double in = 1.0 - fresnel(material, wi.z);
  const double out = 1.0 - fresnel(material, wo.z);
  return coat_eval(material, wo, wi) + material.tint / pi * in * out;
}

double pdf(const CoatedBase& material, glm::dvec3 wo, glm::dvec3 wi) {
  if (wi.z <= 0.0) return 0.0;
  // Either way may have led to wi: both densities count, each as often as its way is chosen.
  const double coat = coat_probability(material, wo);
  return coat * coat_pdf(material, wo, wi) + (1.0 - coat) * wi.z / pi;
}

std::optional<BsdfSample> sample(const CoatedBase& material, glm::dvec3 wo, glm::dvec3 u) {
  // One number chooses, the others make the direction.
  std::optional<glm::dvec3> wi;
  if (u.z < coat_probability(material, wo))
    wi = coat_sample(material, wo, glm::dvec2(u));
  else
    wi = cosine_hemisphere(glm::dvec2(u));
  if (!wi) return std::nullopt;
  const double density = pdf(material, wo, *wi);
  if (density <= 0.0) return std::nullopt;  // a direction along the surface
  return BsdfSample{*wi, eval(material, wo, *wi) * wi->z / density, density};
}

}  // namespace exercise
