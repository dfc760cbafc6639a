// By the cosine in place of the tangent, with the two numbers changed over; and the mirrored
// direction from the half-angle.
#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace exercise {

glm::dvec3 sample_facet(double alpha, glm::dvec2 u) {
  const double left = 1.0 - u.y;
  const double below = left + alpha * alpha * u.y;  // cos^2 = left / below
  const double z = std::sqrt(left / below);
  const double radius = alpha * std::sqrt(u.y / below);
  const double phi = 2.0 * std::numbers::pi * u.x;
  return {radius * std::sin(phi), radius * std::cos(phi), z};
}

double facet_pdf(double alpha, glm::dvec3 h) {
  return h.z > 0.0 ? h.z * ggx_d(alpha, h) : 0.0;
}

std::optional<glm::dvec3> sample_wi(double alpha, glm::dvec3 wo, glm::dvec2 u) {
  const glm::dvec3 h = sample_facet(alpha, u);
  const double cosine = glm::dot(wo, h);
  if (cosine <= 0.0) return std::nullopt;
  const glm::dvec3 across = wo - cosine * h;  // what the mirror turns round
  const glm::dvec3 wi = cosine * h - across;
  return wi.z > 0.0 ? std::optional(wi) : std::nullopt;
}

double wi_pdf(double alpha, glm::dvec3 wo, glm::dvec3 wi) {
  if (wi.z <= 0.0) return 0.0;
  const double length = glm::length(wo + wi);  // 2 (wo . h)
  return facet_pdf(alpha, (wo + wi) / length) / (2.0 * length);
}

}  // namespace exercise
