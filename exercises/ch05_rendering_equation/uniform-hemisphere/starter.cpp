#include "api.hpp"

#include <cmath>

namespace exercise {

glm::dvec3 uniform_hemisphere(glm::dvec2 /*u*/) {
  TODO("turn two numbers into a height and an angle around the normal, then into x, y and z");
}

double uniform_hemisphere_pdf(double /*cos_theta*/) {
  TODO("say how dense the directions lie, above the surface and below it");
}

}  // namespace exercise
