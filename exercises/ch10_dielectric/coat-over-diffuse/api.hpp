/// @file
/// Exercise 10.1: what you write and what you may call. Directions are unit, point away from the
/// surface and are given in its own frame: z along the normal.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <optional>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// A matt base under a clear rough coat, in air.
struct CoatedBase {
  double tint;   ///< albedo of the base, 0 to 1
  double alpha;  ///< width of the coat's facets (GGX)
  double ior;    ///< index of refraction of the coat
};

/// Share of the light from air that a smooth coat reflects (chapter 7), 0 to 1.
[[nodiscard]] inline double fresnel(const CoatedBase& material, double cos_theta) {
  const double n = material.ior;
  const double cos_beyond = std::sqrt(1.0 - (1.0 - cos_theta * cos_theta) / (n * n));
  const double s = (cos_theta - n * cos_beyond) / (cos_theta + n * cos_beyond);
  const double p = (n * cos_theta - cos_beyond) / (n * cos_theta + cos_beyond);
  return (s * s + p * p) / 2.0;
}

/// The coat's facets (chapter 8): their area, 1/sr, and how much of it is hidden along `w`.
[[nodiscard]] inline double ggx_d(double alpha, glm::dvec3 h) {
  const double a = alpha / (h.x * h.x + h.y * h.y + alpha * alpha * h.z * h.z);
  return a * a / std::numbers::pi;
}
[[nodiscard]] inline double ggx_lambda(double alpha, glm::dvec3 w) {
  const double squared_tan = (w.x * w.x + w.y * w.y) / (w.z * w.z);
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * squared_tan) - 1.0);
}

/// The coat alone (chapter 8), without the cosine, 1/sr; 0 unless both directions are above.
[[nodiscard]] inline double coat_eval(const CoatedBase& material, glm::dvec3 wo, glm::dvec3 wi) {
  if (wo.z <= 0.0 || wi.z <= 0.0) return 0.0;
  const glm::dvec3 h = glm::normalize(wo + wi);
  const double hidden = ggx_lambda(material.alpha, wo) + ggx_lambda(material.alpha, wi);
  return fresnel(material, std::fmin(1.0, glm::dot(wo, h))) * ggx_d(material.alpha, h) /
         (4.0 * wo.z * wi.z * (1.0 + hidden));
}

/// A direction by way of a facet that wo sees (chapter 9); nothing where it points below the
/// horizon.
[[nodiscard]] inline std::optional<glm::dvec3> coat_sample(const CoatedBase& material,
                                                           glm::dvec3 wo, glm::dvec2 u) {
  const double alpha = material.alpha;
  const glm::dvec3 view = glm::normalize(glm::dvec3(alpha * wo.x, alpha * wo.y, wo.z));
  const double height = (1.0 - u.y) * (1.0 + view.z);
  const double radius = std::sqrt(std::fmax(0.0, 1.0 - (height - view.z) * (height - view.z)));
  const double phi = 2.0 * std::numbers::pi * u.x;
  const double x = radius * std::cos(phi) + view.x;
  const double y = radius * std::sin(phi) + view.y;
  const glm::dvec3 h = glm::normalize(glm::dvec3(alpha * x, alpha * y, height));
  const glm::dvec3 wi = 2.0 * glm::dot(wo, h) * h - wo;
  if (wi.z <= 0.0) return std::nullopt;
  return wi;
}

/// The density of coat_sample(), 1/sr; 0 for directions below.
[[nodiscard]] inline double coat_pdf(const CoatedBase& material, glm::dvec3 wo, glm::dvec3 wi) {
  if (wi.z <= 0.0) return 0.0;
  return ggx_d(material.alpha, glm::normalize(wo + wi)) /
         (4.0 * wo.z * (1.0 + ggx_lambda(material.alpha, wo)));
}

/// How often to choose the coat, greater than 0 and less than 1.
[[nodiscard]] inline double coat_probability(const CoatedBase& material, glm::dvec3 wo) {
  return 0.25 + 0.5 * fresnel(material, wo.z);
}

/// A direction that follows the cosine (chapter 6): its density is z / pi.
[[nodiscard]] inline glm::dvec3 cosine_hemisphere(glm::dvec2 u) {
  const double radius = std::sqrt(u.x);
  const double phi = 2.0 * std::numbers::pi * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1.0 - u.x)};
}

struct BsdfSample {
  glm::dvec3 wi;
  double weight;  ///< BSDF times cosine of wi over pdf
  double pdf;     ///< 1/sr
};

/// Coat and base together, without the cosine, 1/sr; 0 unless both directions are above.
[[nodiscard]] double eval(const CoatedBase& material, glm::dvec3 wo, glm::dvec3 wi);

/// The density with which sample() gives `wi`, 1/sr.
/// @param wo  above
[[nodiscard]] double pdf(const CoatedBase& material, glm::dvec3 wo, glm::dvec3 wi);

/// A direction of the coat or of the base; nothing where the coat gives none.
/// @param wo  above
/// @param u   three independent random numbers in [0, 1)
[[nodiscard]] std::optional<BsdfSample> sample(const CoatedBase& material, glm::dvec3 wo,
                                               glm::dvec3 u);

}  // namespace exercise
