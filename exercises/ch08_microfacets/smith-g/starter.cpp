#include "api.hpp"

#include <cmath>

namespace exercise {

double smith_lambda(double /*alpha*/, glm::dvec3 /*w*/) {
  TODO("say how much is hidden for each unit that is seen");
}

double smith_g1(double /*alpha*/, glm::dvec3 /*w*/, glm::dvec3 /*h*/) {
  TODO("the share that is seen, of facets that face w");
}

double smith_g2(double /*alpha*/, glm::dvec3 /*wo*/, glm::dvec3 /*wi*/) {
  TODO("the share that is both seen and lit");
}

}  // namespace exercise
