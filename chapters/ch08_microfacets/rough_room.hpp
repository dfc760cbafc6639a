/// @file
/// The three-sphere room, whose metal ball is rough at last.
#pragma once

#include "ch06_importance_sampling/cosine_lambert.hpp"
#include "ch06_importance_sampling/packed_scene.hpp"
#include "ch07_fresnel/smooth.hpp"
#include "ch07_fresnel/smooth_room.hpp"
#include "ch08_microfacets/microfacet.hpp"
#include "ch08_microfacets/roughness.hpp"

namespace lt {

// [rough-metal]
using RoughMetal = MicrofacetReflection<ConductorFresnel>;
using RoughMetalBsdf = OneOf<CosineLambert, RoughMetal, Glass>;

/// Metals are as rough as they say; clear dielectrics are smooth, and all else is matt, as before.
[[nodiscard]] inline RoughMetalBsdf rough_metal_at(const Surface& surface) {
  const Material& material = surface.material;
  if (material.type == MaterialType::metal) {
    const Metal metal{Rgb(material.ior), Rgb(material.extinction)};
    return {RoughMetal{{alpha_of(material.roughness)}, {metal, material.tint}}};
  }
  if (!is_opaque(material)) return {glass_at(surface)};
  return {CosineLambert{material.tint}};
}
// [rough-metal]

// [rough-room]
/// Chapter 7's room, of glass and of a metal of this roughness.
/// @param texels  side of the walls' textures
[[nodiscard]] inline TexturedScene rough_room(int texels, float roughness) {
  TexturedScene scene = smooth_room(texels, 1.5f);
  scene.looks[room::gold_sphere].material.roughness = roughness;
  return scene;
}
// [rough-room]

}  // namespace lt
