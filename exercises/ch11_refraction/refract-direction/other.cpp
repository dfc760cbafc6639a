// By angles: the direction is turned in the plane of wo and normal.
#include "api.hpp"

#include <cmath>

namespace exercise {

std::optional<glm::dvec3> refracted(glm::dvec3 wo, glm::dvec3 normal, double n_outside,
                                    double n_inside) {
  if (glm::dot(wo, normal) < 0.0) return refracted(wo, -normal, n_inside, n_outside);
  const glm::dvec3 across = glm::cross(normal, wo);  // as long as the sine
  const double sine = glm::length(across);
  if (sine == 0.0) return -wo;
  const double beyond = std::asin(n_outside / n_inside * sine);
  if (std::isnan(beyond)) return std::nullopt;
  const glm::dvec3 along = glm::cross(across / sine, normal);  // from the foot of wo, towards it
  return -std::sin(beyond) * along - std::cos(beyond) * normal;
}

}  // namespace exercise
