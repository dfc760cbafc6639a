// No disk: a point of the unit sphere that touches the surface from above, its centre at the tip of
// the normal. Seen from where it touches, its points follow the cosine.
#include "api.hpp"

#include <cmath>
#include <numbers>

namespace exercise {

glm::dvec3 cosine_hemisphere(glm::dvec2 u) {
  const double height = 2.0 * (1.0 - u.y);  // of the point above the surface, 0 to 2
  const double radius = std::sqrt(height * (2.0 - height));
  const double phi = 2.0 * std::numbers::pi * u.x;
  return glm::normalize(glm::dvec3(radius * std::sin(phi), radius * std::cos(phi), height));
}

double cosine_hemisphere_pdf(double cos_theta) {
  if (cos_theta <= 0.0) return 0.0;
  return cos_theta * std::numbers::inv_pi;
}

}  // namespace exercise
