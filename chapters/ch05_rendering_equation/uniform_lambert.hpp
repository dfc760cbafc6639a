/// @file
/// A matt surface, sampled in the plainest way.
#pragma once

#include "ch03_surfaces/surface.hpp"
#include "ch05_rendering_equation/bsdf.hpp"
#include "ch05_rendering_equation/uniform_hemisphere.hpp"

namespace lt {

// [lambert]
/// The value of Lambert's BRDF: as bright from every side. Albedo / pi, because the cosine
/// integrates to pi over the hemisphere.
/// @param albedo  share of the light that it gives back, 0 to 1
/// @return 1/sr; 0 where wo and wi are on different sides
[[nodiscard]] inline Rgb lambert(Rgb albedo, vec3 wo, vec3 wi) {
  return same_side(wo, wi) ? albedo / pi : Rgb(0.0f);
}
// [lambert]

// [uniform-lambert]
/// Lambert's surface, which asks all directions alike.
struct UniformLambert {
  Rgb albedo;  ///< 0 to 1

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const { return lambert(albedo, wo, wi); }

  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const vec3 wi = uniform_hemisphere(vec2(u));
    return BsdfSample{wi, eval(wo, wi) * wi.z / uniform_hemisphere_pdf, uniform_hemisphere_pdf};
  }

  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    return same_side(wo, wi) ? uniform_hemisphere_pdf : 0.0f;
  }
};
// [uniform-lambert]

/// Every surface as matt as chalk, whatever its material says.
[[nodiscard]] inline UniformLambert uniform_lambert_at(const Surface& surface) {
  return {surface.material.tint};
}

}  // namespace lt
