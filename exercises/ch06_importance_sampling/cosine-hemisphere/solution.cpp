#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

namespace {

const double pi = std::acos(-1.0);

}  // namespace

glm::dvec3 cosine_hemisphere(glm::dvec2 u) {
  // Malley: a patch of the sphere, seen from above, is smaller by its cosine. Points spread evenly
  // over the disk and lifted up to the sphere lie denser where the cosine is large.
  const double radius = std::sqrt(u.x);  // the disk within r has the share r * r of the area
  const double z = std::sqrt(1.0 - u.x);
  const double phi = 2.0 * pi * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

double cosine_hemisphere_pdf(double cos_theta) {
  // The cosine over the hemisphere sums to pi. No direction points into the surface.
  return std::max(0.0, cos_theta) / pi;
}

}  // namespace exercise
