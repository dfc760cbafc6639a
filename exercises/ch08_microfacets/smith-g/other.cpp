// With cosines instead of tangents: every formula is multiplied through by them, so that a level
// direction needs no infinity.
#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

namespace {

double cosine(glm::dvec3 w) {
  return std::min(std::abs(w.z), 1.0);
}

// cos (1 + 2 Lambda)
double slant(double alpha, glm::dvec3 w) {
  const double squared = cosine(w) * cosine(w);
  return std::sqrt(squared + alpha * alpha * (1.0 - squared));
}

}  // namespace

double smith_lambda(double alpha, glm::dvec3 w) {
  return (slant(alpha, w) / cosine(w) - 1.0) / 2.0;
}

double smith_g1(double alpha, glm::dvec3 w, glm::dvec3 h) {
  const bool is_front = w.z > 0.0 ? glm::dot(w, h) > 0.0 : glm::dot(w, h) < 0.0;
  if (w.z == 0.0 || !is_front) return 0.0;
  return 2.0 * cosine(w) / (cosine(w) + slant(alpha, w));
}

double smith_g2(double alpha, glm::dvec3 wo, glm::dvec3 wi) {
  if (wo.z == 0.0 || wi.z == 0.0 || std::signbit(wo.z) != std::signbit(wi.z)) return 0.0;
  const double both = cosine(wo) * slant(alpha, wi) + cosine(wi) * slant(alpha, wo);
  return 2.0 * cosine(wo) * cosine(wi) / both;
}

}  // namespace exercise
