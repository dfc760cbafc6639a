#include "api.hpp"

#include <cmath>

namespace exercise {

double eval(const CoatedBase& /*material*/, glm::dvec3 /*wo*/, glm::dvec3 /*wi*/) {
  TODO("add what the coat reflects and what the base sends back through it");
}

double pdf(const CoatedBase& /*material*/, glm::dvec3 /*wo*/, glm::dvec3 /*wi*/) {
  TODO("say how dense the directions of sample() lie, whichever way they came about");
}

std::optional<BsdfSample> sample(const CoatedBase& /*material*/, glm::dvec3 /*wo*/,
                                 glm::dvec3 /*u*/) {
  TODO("choose the coat or the base, and take a direction of it");
}

}  // namespace exercise
