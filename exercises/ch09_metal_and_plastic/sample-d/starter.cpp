#include "api.hpp"

#include <cmath>

namespace exercise {

glm::dvec3 sample_facet(double /*alpha*/, glm::dvec2 /*u*/) {
  TODO("turn two numbers into a lean and an angle around the normal, then into x, y and z");
}

double facet_pdf(double /*alpha*/, glm::dvec3 /*h*/) {
  TODO("say how dense the facets' normals lie");
}

std::optional<glm::dvec3> sample_wi(double /*alpha*/, glm::dvec3 /*wo*/, glm::dvec2 /*u*/) {
  TODO("let such a facet mirror wo; nothing where that is not above the surface");
}

double wi_pdf(double /*alpha*/, glm::dvec3 /*wo*/, glm::dvec3 /*wi*/) {
  TODO("say how dense the mirrored directions lie");
}

}  // namespace exercise
