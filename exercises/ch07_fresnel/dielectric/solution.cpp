#include "api.hpp"

#include <cmath>

namespace exercise {

Reflectance reflectance_dielectric(double cos_here, double n_here, double n_beyond) {
  if (n_here == n_beyond) return {0.0, 0.0};  // no surface; at the horizon it would be 0 / 0
  const double eta = n_here / n_beyond;
  // Snell's sine, squared. No root is taken, so that a cosine a little above 1 does no harm.
  const double squared_sin_here = 1.0 - cos_here * cos_here;
  const double squared_cos = 1.0 - eta * eta * squared_sin_here;
  if (squared_cos <= 0.0) return {1.0, 1.0};  // no angle beyond has such a sine
  const double cos_beyond = std::sqrt(squared_cos);
  const double s =
      (n_here * cos_here - n_beyond * cos_beyond) / (n_here * cos_here + n_beyond * cos_beyond);
  const double p =
      (n_beyond * cos_here - n_here * cos_beyond) / (n_beyond * cos_here + n_here * cos_beyond);
  return {s * s, p * p};  // the waves' heights become shares of energy
}

double fresnel_dielectric(double cos_here, double n_here, double n_beyond) {
  const Reflectance share = reflectance_dielectric(cos_here, n_here, n_beyond);
  return (share.s + share.p) / 2.0;  // half of the light swings either way
}

}  // namespace exercise
