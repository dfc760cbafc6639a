#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

glm::dvec3 cosine_hemisphere(glm::dvec2 /*u*/) {
  TODO("find a point of the disk, all equally likely, and lift it up to the sphere");
}

double cosine_hemisphere_pdf(double /*cos_theta*/) {
  TODO("say how dense the directions lie, above the surface and below it");
}

}  // namespace exercise
