#include "api.hpp"

#include <cmath>

namespace exercise {

Rgb transmittance(Rgb /*attenuation*/, double /*distance*/) {
  TODO("say how much of each colour is left");
}

Rgb pane_transmittance(Rgb /*attenuation*/, double /*thickness*/, double /*cos_here*/,
                       double /*n_here*/, double /*n_beyond*/) {
  TODO("find the length of the bent ray's way through the pane");
}

Rgb path_transmittance(glm::dvec3 /*camera*/, std::span<const Vertex> /*path*/) {
  TODO("multiply what is left of the segments that lie inside an object");
}

}  // namespace exercise
