#include "api.hpp"

#include <cmath>

namespace exercise {

double smith_lambda(double alpha, glm::dvec3 w) {
  // From x, y and z: no angle is needed, and no 1 - z^2, negative where rounding makes z exceed 1.
  const double squared_tan = (w.x * w.x + w.y * w.y) / (w.z * w.z);
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * squared_tan) - 1.0);
}

double smith_g1(double alpha, glm::dvec3 w, glm::dvec3 h) {
  // From above one sees the front of facets; from below (w.z negative) their back is the front.
  if (!(glm::dot(w, h) * w.z > 0.0)) return 0.0;
  // Of 1 + Lambda units, 1 is seen. Smith: whether a facet is hidden has nothing to do with the way
  // it faces, so h does not come in again.
  return 1.0 / (1.0 + smith_lambda(alpha, w));
}

double smith_g2(double alpha, glm::dvec3 wo, glm::dvec3 wi) {
  if (!(wo.z * wi.z > 0.0)) return 0.0;
  // A facet that lies high is both seen and lit more often: more is left than the product says.
  return 1.0 / (1.0 + smith_lambda(alpha, wo) + smith_lambda(alpha, wi));
}

}  // namespace exercise
