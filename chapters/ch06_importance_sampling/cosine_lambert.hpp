/// @file
/// A matt surface, sampled where its light comes from.
#pragma once

#include "ch05_rendering_equation/uniform_lambert.hpp"
#include "ch06_importance_sampling/cosine_hemisphere.hpp"

namespace lt {

// [cosine-lambert]
/// Lambert's surface, which asks in proportion to the cosine.
struct CosineLambert {
  Rgb albedo;  ///< 0 to 1

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const { return lambert(albedo, wo, wi); }

  [[nodiscard]] std::optional<BsdfSample> sample(vec3 /*wo*/, vec3 u) const {
    const vec3 wi = cosine_hemisphere(vec2(u));
    // (albedo / pi) cos / (cos / pi): only the albedo is left.
    return BsdfSample{wi, albedo, cosine_hemisphere_pdf(wi.z)};
  }

  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    return same_side(wo, wi) ? cosine_hemisphere_pdf(wi.z) : 0.0f;
  }
};
// [cosine-lambert]

/// Every surface as matt as chalk, whatever its material says.
[[nodiscard]] inline CosineLambert cosine_lambert_at(const Surface& surface) {
  return {surface.material.tint};
}

}  // namespace lt
