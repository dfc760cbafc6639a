#include "api.hpp"

#include <cmath>

namespace exercise {

Rgb transmittance(Rgb attenuation, double distance) {
  // Each thin layer takes the same share of what reaches it, so that layers multiply.
  return glm::exp(-attenuation * distance);
}

Rgb pane_transmittance(Rgb attenuation, double thickness, double cos_here, double n_here,
                       double n_beyond) {
  // Inside, the ray runs at another angle (Snell). Its way is longer than the pane is thick.
  const double sin_here = std::sqrt(1.0 - cos_here * cos_here);
  const double sin_beyond = n_here / n_beyond * sin_here;
  const double cos_beyond = std::sqrt(1.0 - sin_beyond * sin_beyond);
  return transmittance(attenuation, thickness / cos_beyond);
}

Rgb path_transmittance(glm::dvec3 camera, std::span<const Vertex> path) {
  Rgb left(1.0);
  glm::dvec3 from = camera;
  for (const Vertex& vertex : path) {
    // Who meets a surface from inside has come through the object.
    const double distance = glm::distance(from, vertex.position);
    if (!vertex.outside) left *= transmittance(vertex.attenuation, distance);
    from = vertex.position;
  }
  return left;
}

}  // namespace exercise
