// One number does both: what is left of it after the choice is random too. The base comes first.
#include "api.hpp"

#include <numbers>

namespace exercise {

double eval(const CoatedBase& material, glm::dvec3 wo, glm::dvec3 wi) {
  if (!(wo.z > 0.0 && wi.z > 0.0)) return 0.0;
  const double o = fresnel(material, wo.z);
  const double i = fresnel(material, wi.z);
  const double through = 1.0 - o - i + o * i;
  return through * material.tint * std::numbers::inv_pi + coat_eval(material, wo, wi);
}

double pdf(const CoatedBase& material, glm::dvec3 wo, glm::dvec3 wi) {
  if (!(wi.z > 0.0)) return 0.0;
  const double base = wi.z * std::numbers::inv_pi;
  return base + coat_probability(material, wo) * (coat_pdf(material, wo, wi) - base);
}

std::optional<BsdfSample> sample(const CoatedBase& material, glm::dvec3 wo, glm::dvec3 u) {
  const double base = 1.0 - coat_probability(material, wo);
  const glm::dvec2 stretched(u.y < base ? u.y / base : (u.y - base) / (1.0 - base), u.z);
  const auto wi = u.y < base ? std::optional(cosine_hemisphere(stretched))
                             : coat_sample(material, wo, stretched);
  if (!wi || !(wi->z > 0.0)) return {};
  const double density = pdf(material, wo, *wi);
  return BsdfSample{*wi, eval(material, wo, *wi) / density * wi->z, density};
}

}  // namespace exercise
