#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

glm::dvec3 half_vector(glm::dvec3 /*wo*/, glm::dvec3 /*wi*/) {
  TODO("find the direction half-way between");
}

double ggx_eval(double /*alpha*/, const Fresnel& /*fresnel*/, glm::dvec3 /*wo*/,
                glm::dvec3 /*wi*/) {
  TODO("put D, G and Fresnel together");
}

}  // namespace exercise
