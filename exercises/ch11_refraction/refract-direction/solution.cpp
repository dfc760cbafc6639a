#include "api.hpp"

#include <cmath>

namespace exercise {

std::optional<glm::dvec3> refracted(glm::dvec3 wo, glm::dvec3 normal, double n_outside,
                                    double n_inside) {
  // From here on there is no inside and outside, only this side, wo's, and the one beyond.
  const bool is_outside = glm::dot(wo, normal) > 0.0;
  const glm::dvec3 h = is_outside ? normal : -normal;
  const double eta = is_outside ? n_outside / n_inside : n_inside / n_outside;

  // Snell's law, squared: sines can do without angles.
  const double cos_here = glm::dot(wo, h);
  const double squared_sin = eta * eta * (1.0 - cos_here * cos_here);
  if (squared_sin >= 1.0) return std::nullopt;  // no angle has such a sine

  // What lies along the surface is as long as the sine, and what is left of length 1 points down.
  const double cos_beyond = std::sqrt(1.0 - squared_sin);
  const glm::dvec3 along = -eta * (wo - cos_here * h);
  return along - cos_beyond * h;
}

}  // namespace exercise
