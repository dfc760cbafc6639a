#include "api.hpp"

#include <cmath>

namespace exercise {

float ggx_d(float /*alpha*/, glm::vec3 /*h*/) {
  TODO("say how much area of facets faces h");
}

float brushed_ggx_d(glm::vec2 /*alphas*/, glm::vec3 /*h*/) {
  TODO("the same with a width along x and another along y");
}

float ggx_d_between(float /*alpha*/, glm::vec3 /*wo*/, glm::vec3 /*wi*/) {
  TODO("find the facets that mirror wi to wo");
}

}  // namespace exercise
