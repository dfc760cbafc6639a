#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

std::optional<Sample> ggx_sample(double /*alpha*/, const Fresnel& /*fresnel*/, glm::dvec3 /*wo*/,
                                 glm::dvec2 /*u*/) {
  TODO("let a facet mirror wo, and say what light from there counts");
}

}  // namespace exercise
