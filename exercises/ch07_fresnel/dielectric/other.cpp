// Walter's form (2007, eq. 22): no index but the quotient, and no cosine beyond: g is the quotient
// times that cosine.
#include "api.hpp"

#include <cmath>

namespace exercise {

Reflectance reflectance_dielectric(double c, double n_here, double n_beyond) {
  const double n = n_beyond / n_here;
  const double squared_g = (n - 1.0) * (n + 1.0) + c * c;
  if (squared_g < 0.0) return {1.0, 1.0};
  const double g = std::sqrt(squared_g);
  if (g + c == 0.0) return {0.0, 0.0};  // along a surface that is none
  const double across = (g - c) / (g + c);
  const double in_plane = across * (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return {across * across, in_plane * in_plane};
}

double fresnel_dielectric(double cos_here, double n_here, double n_beyond) {
  const auto [s, p] = reflectance_dielectric(cos_here, n_here, n_beyond);
  return 0.5 * s + 0.5 * p;
}

}  // namespace exercise
