#include "api.hpp"

#include <cmath>

namespace exercise {

glm::dvec3 sample_visible(double /*alpha*/, glm::dvec3 /*wo*/, glm::dvec2 /*u*/) {
  TODO("stretch the view, take a facet of half a ball that it sees, and flatten again");
}

double visible_pdf(double /*alpha*/, glm::dvec3 /*wo*/, glm::dvec3 /*h*/) {
  TODO("say how dense the normals lie");
}

double visible_weight(double /*alpha*/, glm::dvec3 /*wo*/, glm::dvec3 /*wi*/) {
  TODO("say what of a facet that is seen is also lit");
}

}  // namespace exercise
