/// @file
/// What happens at a surface, as far as the course has come: matt, mirror or glass.
#pragma once

#include "ch06_importance_sampling/cosine_lambert.hpp"
#include "ch07_fresnel/glass.hpp"
#include "ch07_fresnel/mirror.hpp"
#include "ch07_fresnel/one_of.hpp"

namespace lt {

// [smooth-at]
using SmoothBsdf = OneOf<CosineLambert, Mirror, Glass>;

/// Metals are mirrors, clear dielectrics are glass, all else is matt as before: as if nothing were
/// rough, nothing wore a coat, and glass swallowed no light.
[[nodiscard]] inline SmoothBsdf smooth_bsdf_at(const Surface& surface) {
  const Material& material = surface.material;
  if (material.type == MaterialType::metal)
    return {Mirror{{Rgb(material.ior), Rgb(material.extinction)}, material.tint}};
  if (!is_opaque(material)) return {glass_at(surface)};
  return {CosineLambert{material.tint}};
}
// [smooth-at]

// [smooth-scattering]
/// The same in a scene all of whose metals are `metal`: a material has room for one number where a
/// real metal has three.
struct SmoothWithMetal {
  Metal metal;

  [[nodiscard]] SmoothBsdf operator()(const Surface& surface) const {
    if (surface.material.type == MaterialType::metal) return {Mirror{metal}};
    return smooth_bsdf_at(surface);
  }
};
// [smooth-scattering]

}  // namespace lt
