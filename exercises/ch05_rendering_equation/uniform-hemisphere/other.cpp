// The whole sphere first, then folded: what lies below is turned to the opposite side. And the two
// numbers have changed places.
#include "api.hpp"

#include <cmath>
#include <numbers>

namespace exercise {

glm::dvec3 uniform_hemisphere(glm::dvec2 u) {
  const double z = 2.0 * u.y - 1.0;
  const double radius = std::sqrt(1.0 - z * z);
  const double phi = std::numbers::pi * (2.0 * u.x - 1.0);
  const glm::dvec3 anywhere(radius * std::sin(phi), radius * std::cos(phi), z);
  return z < 0.0 ? -anywhere : anywhere;
}

double uniform_hemisphere_pdf(double cos_theta) {
  const double whole_sphere = 4.0 * std::numbers::pi;
  return cos_theta > 0.0 ? 2.0 / whole_sphere : 0.0;  // two places of the sphere fold onto one
}

}  // namespace exercise
