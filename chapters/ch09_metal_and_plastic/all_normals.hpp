/// @file
/// Choosing among all facets, as if none hid another.
#pragma once

#include <algorithm>
#include <cmath>

#include "ch09_metal_and_plastic/normal_sampler.hpp"

namespace lt {

// [all-normals]
/// Facets as often as the surface has them: with density D(h) h.z, from wherever one looks. What
/// the thesis does; Walter et al. 2007, section 5.3.
struct AllNormals {
  // [all-normals-sample]
  /// Thesis eqs. 13 and 14 (Walter et al. 2007, eqs. 35 and 36): tan(theta) =
  /// alpha sqrt(u.x / (1 - u.x)), without taking an arc tangent and its cosine.
  /// @param u  each in [0, 1)
  /// @return unit, local frame, z > 0
  [[nodiscard]] static vec3 sample(const Ggx& ggx, vec3 /*wo*/, vec2 u) {
    const float opposite = ggx.alpha * std::sqrt(u.x);  // of theta, in a right-angled triangle
    const float adjacent = std::sqrt(1.0f - u.x);
    const float hypotenuse = std::sqrt(opposite * opposite + adjacent * adjacent);
    const float phi = 2.0f * pi * u.y;
    return vec3(opposite * std::cos(phi), opposite * std::sin(phi), adjacent) / hypotenuse;
  }
  // [all-normals-sample]

  // [all-normals-pdf]
  /// @return 1/sr
  [[nodiscard]] static float pdf(const Ggx& ggx, vec3 /*wo*/, vec3 h) {
    return ggx.d(h) * std::max(0.0f, h.z);
  }
  // [all-normals-pdf]

  // [all-normals-weight]
  /// Thesis eq. 17 (Walter et al. 2007, eq. 41).
  /// @return positive; below 2 / wo.z^2, because wi lies above the horizon only if
  ///         h.z > wo.z / (2 wo.h): no bound that holds for all wo
  [[nodiscard]] static float weight(const Ggx& /*ggx*/, vec3 wo, vec3 h, float seen) {
    return seen * dot(wo, h) / wo.z / h.z;
  }
  // [all-normals-weight]
};
// [all-normals]

static_assert(NormalSampler<AllNormals>);

}  // namespace lt
