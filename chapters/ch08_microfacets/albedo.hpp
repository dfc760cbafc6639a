/// @file
/// How much of the light a surface gives back in all.
#pragma once

#include <cmath>

#include "ch07_fresnel/ideal_directions.hpp"

namespace lt {

// [albedo]
/// Radiance towards `wo` under a sky of radiance 1: the integral of f cos over all directions wi.
/// Because f is the same both ways, it is also the share of the light from `wo` that goes anywhere.
/// The integral goes over facets, each of which stands for the direction that it mirrors:
/// d(omega_i) = 4 cos d(omega_h) (Walter et al. 2007, eq. 14). So it is fine where the lobe is.
/// @param value  f(wo, wi), 1/sr
/// @param alpha  about how steep facets are
/// @param steps  over steps x steps facets, whose slopes go from 0 to infinity
/// @return of the green channel; no noise, but an error that falls with the steps
template <class Value>
[[nodiscard]] double albedo(const Value& value, float alpha, vec3 wo, int steps) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double v = (i + 0.5) / steps;
    const double slope = alpha * v / (1 - v);
    const double z = 1 / std::sqrt(1 + slope * slope);
    // sin d(theta) = slope z^3 d(slope), and d(slope) = alpha / (1 - v)^2 dv.
    const double solid_angle = slope * z * z * z * alpha / ((1 - v) * (1 - v));
    for (int j = 0; j < steps; ++j) {
      const double phi = double{pi} * (j + 0.5) / steps;  // the other half is its mirror image
      const vec3 h(slope * z * std::cos(phi), slope * z * std::sin(phi), z);
      const float cosine = dot(wo, h);
      const vec3 wi = reflected(wo, h);
      if (cosine > 0.0f && wi.z > 0.0f) sum += solid_angle * 4 * cosine * value(wo, wi).g * wi.z;
    }
  }
  return 2 * double{pi} * sum / steps / steps;
}
// [albedo]

/// The direction in the plane of x and z whose cosine is `mu`.
[[nodiscard]] inline vec3 at_cosine(float mu) {
  return {std::sqrt((1.0f - mu) * (1.0f + mu)), 0.0f, mu};
}

}  // namespace lt
