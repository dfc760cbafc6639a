// Optical depths, attenuation times length, are summed; the exponential comes last. The way through
// the pane follows from its two sides: across, and along by the tangent of the bent ray.
#include "api.hpp"

#include <cmath>
#include <cstddef>

namespace exercise {

namespace {

Rgb left_of(Rgb depth) {
  return {std::exp(-depth.r), std::exp(-depth.g), std::exp(-depth.b)};
}

}  // namespace

Rgb transmittance(Rgb attenuation, double distance) {
  return left_of(distance * attenuation);
}

Rgb pane_transmittance(Rgb attenuation, double thickness, double cos_here, double n_here,
                       double n_beyond) {
  const double theta = std::asin(std::sin(std::acos(cos_here)) * n_here / n_beyond);
  return left_of(attenuation * std::hypot(thickness, thickness * std::tan(theta)));
}

Rgb path_transmittance(glm::dvec3 camera, std::span<const Vertex> path) {
  Rgb depth(0.0);
  for (std::size_t i = path.size(); i-- > 0;) {
    if (path[i].outside) continue;
    const glm::dvec3 segment = path[i].position - (i == 0 ? camera : path[i - 1].position);
    depth += path[i].attenuation * std::sqrt(glm::dot(segment, segment));
  }
  return left_of(depth);
}

}  // namespace exercise
