#include "api.hpp"

#include <cmath>

namespace exercise {

Quaternion product(Quaternion /*a*/, Quaternion /*b*/) {
  TODO("multiply out, with i j = k but j i = -k");
}

Quaternion about(glm::vec3 /*axis*/, float /*angle*/) {
  TODO("make the quaternion of a rotation");
}

glm::vec3 rotate(Quaternion /*q*/, glm::vec3 /*v*/) {
  TODO("turn v: q v q*");
}

Quaternion spin(Quaternion /*now*/, Quaternion /*step*/) {
  TODO("turn further by step, and stay unit");
}

float sphere_u(Quaternion /*rotation*/, glm::vec3 /*n*/) {
  TODO("0.5 + atan2(x, -z) / (2 pi), in the sphere's own axes");
}

}  // namespace exercise
