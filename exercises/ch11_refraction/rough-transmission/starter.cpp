#include "api.hpp"

#include <cmath>

namespace exercise {

glm::dvec3 transmission_half_vector(glm::dvec3 /*wo*/, glm::dvec3 /*wi*/, double /*n_here*/,
                                    double /*n_beyond*/) {
  TODO("find the facets' normal by Snell's law, and turn it up");
}

double eval(const RoughGlass& /*glass*/, glm::dvec3 /*wo*/, glm::dvec3 /*wi*/) {
  TODO("say how much radiance comes through");
}

double pdf(const RoughGlass& /*glass*/, glm::dvec3 /*wo*/, glm::dvec3 /*wi*/) {
  TODO("turn the density of facets into one of directions");
}

std::optional<BsdfSample> sample(const RoughGlass& /*glass*/, glm::dvec3 /*wo*/, glm::dvec2 /*u*/) {
  TODO("draw a facet and let it bend the ray");
}

}  // namespace exercise
