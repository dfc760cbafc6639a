#include "api.hpp"

#include <cstddef>

namespace exercise {

double crossing_scale(double n_here, double n_beyond, Transport transport) {
  // Energy is neither made nor lost where light is bent.
  if (transport == Transport::importance) return 1.0;
  // But in the denser medium it is squeezed into fewer directions, and radiance is energy per
  // direction. It comes from beyond and is seen here.
  const double eta = n_here / n_beyond;
  return eta * eta;
}

Choice choose(double share, double u, double n_here, double n_beyond, Transport transport) {
  // Each way has its share of light as weight and the same share as probability: they cancel.
  if (u < share) return {false, 1.0};
  return {true, crossing_scale(n_here, n_beyond, transport)};
}

double light_at_camera(double light, std::span<const double> indices) {
  double scale = 1.0;
  for (std::size_t i = 1; i < indices.size(); ++i)
    scale *= crossing_scale(indices[i - 1], indices[i], Transport::radiance);
  return scale * light;
}

}  // namespace exercise
