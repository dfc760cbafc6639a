/// @file
/// Choosing among the facets that one sees.
#pragma once

#include <algorithm>
#include <cmath>

#include "ch08_microfacets/masking.hpp"
#include "ch09_metal_and_plastic/normal_sampler.hpp"

namespace lt {

// [visible-normals]
/// Facets as often as one sees them: in proportion to their area as it appears along wo, without
/// the part that is hidden. Heitz and d'Eon 2014.
struct VisibleNormals {
  // [visible-normals-sample]
  /// GGX facets lean as those of half an ellipsoid do, of radius 1 and height alpha. Stretched to a
  /// half sphere, the facets that one sees mirror the view evenly into a cap of the sphere of
  /// directions: all those higher than -view.z. So take one of these, and the normal half-way to
  /// it. Dupuy and Benyoub 2023.
  /// @param u  each in [0, 1)
  /// @return unit, local frame, z > 0
  [[nodiscard]] static vec3 sample(const Ggx& ggx, vec3 wo, vec2 u) {
    const vec3 view = normalize(vec3(ggx.alpha * wo.x, ggx.alpha * wo.y, wo.z));
    // Archimedes: on a sphere, even heights are even areas. This one counts from the cap's rim.
    const float height = (1.0f - u.y) * (1.0f + view.z);
    const float z = height - view.z;
    const float radius = std::sqrt(std::max(0.0f, (1.0f - z) * (1.0f + z)));
    const float phi = 2.0f * pi * u.x;
    const vec2 across(radius * std::cos(phi) + view.x, radius * std::sin(phi) + view.y);
    return normalize(vec3(ggx.alpha * across, height));  // flat again, normals rise
  }
  // [visible-normals-sample]

  // [visible-normals-pdf]
  /// Heitz and d'Eon 2014.
  /// @return 1/sr; 0 for facets that show wo their back
  [[nodiscard]] static float pdf(const Ggx& ggx, vec3 wo, vec3 h) {
    return g1(ggx, wo, h) * ggx.d(h) * dot(wo, h) / wo.z;
  }
  // [visible-normals-pdf]

  // [visible-normals-weight]
  /// G2 / G1(wo): that the facet is seen is paid for.
  /// @return 0 to 1
  [[nodiscard]] static float weight(const Ggx& ggx, vec3 wo, vec3 /*h*/, float seen) {
    return seen * (1.0f + ggx.lambda(wo));
  }
  // [visible-normals-weight]
};
// [visible-normals]

static_assert(NormalSampler<VisibleNormals>);

}  // namespace lt
