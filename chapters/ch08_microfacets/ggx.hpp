/// @file
/// How the facets of a rough surface lean, and how much they stand in each other's way.
#pragma once

#include <cmath>

#include "common/math.hpp"

namespace lt {

// [ggx]
/// The GGX distribution of facets (Trowbridge and Reitz 1975; Walter et al. 2007).
struct Ggx {
  float alpha;  ///< width: tangent of the angle by which facets lean, > 0; d() and lambda() hold to
                ///< 1e-4

  // [d]
  /// Area of the facets that face `h`, in m^2 of facet per m^2 of surface and steradian. Thesis
  /// eq. 6, corrected: the angle is that of h (Walter et al. 2007, eq. 33). In a form without
  /// tangents: tan^2 = (x^2 + y^2) / z^2, and z^4 cancels.
  /// @param h  a facet's normal, unit, local frame
  /// @return 1/sr; 0 for facets that face down
  [[nodiscard]] float d(vec3 h) const {
    if (!(h.z > 0.0f)) return 0.0f;
    const float a = alpha / (h.x * h.x + h.y * h.y + alpha * alpha * h.z * h.z);
    return a * a / pi;
  }
  // [d]

  // [lambda]
  /// Of the facets that face `w`, the area hidden by others for each unit that is seen; Smith 1967,
  /// for GGX: Walter et al. 2007, eq. 34; Heitz 2014.
  /// @param w  to whoever looks, unit, local frame; either side
  /// @return 0 straight above to infinity at the horizon
  [[nodiscard]] float lambda(vec3 w) const {
    const float squared_tan = (w.x * w.x + w.y * w.y) / (w.z * w.z);
    return 0.5f * (std::sqrt(1.0f + alpha * alpha * squared_tan) - 1.0f);
  }
  // [lambda]
};
// [ggx]

}  // namespace lt
