#include "api.hpp"

#include <cmath>

namespace exercise {

std::optional<glm::dvec3> refracted(glm::dvec3 /*wo*/, glm::dvec3 /*normal*/, double /*n_outside*/,
                                    double /*n_inside*/) {
  TODO("find the side that wo is on, then bend the ray by Snell's law");
}

}  // namespace exercise
