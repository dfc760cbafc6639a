#include "api.hpp"

#include <cmath>

namespace exercise {

namespace {

const double pi = std::acos(-1.0);

}  // namespace

glm::dvec3 uniform_hemisphere(glm::dvec2 u) {
  // Slices of equal height have equal area (Archimedes): all heights are equally likely.
  const double z = 1.0 - u.x;
  // What is left of length 1. It is 1 - z * z, written so that nothing cancels near the pole.
  const double radius = std::sqrt(u.x * (2.0 - u.x));
  const double phi = 2.0 * pi * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

double uniform_hemisphere_pdf(double cos_theta) {
  // The same everywhere, and 1 in sum over an area of 2 pi. No direction points into the surface.
  return cos_theta < 0.0 ? 0.0 : 1.0 / (2.0 * pi);
}

}  // namespace exercise
