// Radiance over the square of the index stays the same along a path. So only its two ends count.
#include "api.hpp"

namespace exercise {

namespace {

double square(double x) {
  return x * x;
}

}  // namespace

double crossing_scale(double n_here, double n_beyond, Transport transport) {
  return transport == Transport::radiance ? square(n_here) / square(n_beyond) : 1.0;
}

Choice choose(double share, double u, double n_here, double n_beyond, Transport transport) {
  const bool is_reflected = share > u;
  const double part = is_reflected ? share : 1.0 - share;
  const double scale = is_reflected ? 1.0 : crossing_scale(n_here, n_beyond, transport);
  return {!is_reflected, part * scale / part};
}

double light_at_camera(double light, std::span<const double> indices) {
  return light / square(indices.back()) * square(indices.front());
}

}  // namespace exercise
