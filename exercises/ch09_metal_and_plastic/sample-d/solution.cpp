#include "api.hpp"

#include <cmath>
#include <numbers>

namespace exercise {

using std::numbers::pi;

glm::dvec3 sample_facet(double alpha, glm::dvec2 u) {
  // The share of the surface that leans by less than theta is tan^2 / (alpha^2 + tan^2): solved
  // for the tangent. 1 - u.x is never 0.
  const double tan = alpha * std::sqrt(u.x / (1.0 - u.x));
  const double phi = 2.0 * pi * u.y;
  // A normal that leans by x / z and y / z.
  return glm::normalize(glm::dvec3(tan * std::cos(phi), tan * std::sin(phi), 1.0));
}

double facet_pdf(double alpha, glm::dvec3 h) {
  return ggx_d(alpha, h) * h.z;  // the facets, seen from straight above, cover the surface once
}

std::optional<glm::dvec3> sample_wi(double alpha, glm::dvec3 wo, glm::dvec2 u) {
  const glm::dvec3 h = sample_facet(alpha, u);
  const glm::dvec3 wi = 2.0 * glm::dot(wo, h) * h - wo;
  // Facets that show wo their back mirror it down, and so do some others. A new try would make all
  // other directions denser than wi_pdf() says.
  if (wi.z <= 0.0) return std::nullopt;
  return wi;
}

double wi_pdf(double alpha, glm::dvec3 wo, glm::dvec3 wi) {
  if (wi.z <= 0.0) return 0.0;
  const glm::dvec3 h = glm::normalize(wo + wi);
  // The facet turns by a little, the direction by twice that: the same number of them is spread
  // over 4 (wo . h) times the solid angle.
  return facet_pdf(alpha, h) / (4.0 * glm::dot(wo, h));
}

}  // namespace exercise
