#include "api.hpp"

#include <cmath>

namespace exercise {

double lambert(double /*albedo*/, glm::dvec3 /*wo*/, glm::dvec3 /*wi*/) {
  TODO("say how much of the light from wi goes towards wo");
}

double reflected(double /*albedo*/, glm::dvec3 /*wo*/, const Sampler& /*sampler*/,
                 const Sky& /*sky*/, std::span<const glm::dvec2> /*us*/) {
  TODO("ask the sky once for each pair of numbers, and take the mean");
}

}  // namespace exercise
