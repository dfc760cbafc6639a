/// @file
/// What happens at a surface, as far as the course has come: metal, plastic, glass, or matt.
#pragma once

#include "ch06_importance_sampling/cosine_lambert.hpp"
#include "ch07_fresnel/glass.hpp"
#include "ch07_fresnel/mirror.hpp"
#include "ch07_fresnel/one_of.hpp"
#include "ch09_metal_and_plastic/metal_and_plastic.hpp"

namespace lt {

// [rough-at]
template <NormalSampler Normals = VisibleNormals>
using RoughBsdf =
    OneOf<CosineLambert, Mirror, Glass, MetalReflection<Normals>, PlasticReflection<Normals>>;

/// Metal and plastic are rough, or mirrors where they are polished. Clear dielectrics are still
/// smooth glass, opaque ones still matt: as if they wore no coat.
/// @tparam Normals  how facets are chosen
template <NormalSampler Normals = VisibleNormals>
[[nodiscard]] RoughBsdf<Normals> rough_bsdf_at(const Surface& surface) {
  const Material& material = surface.material;
  if (material.type == MaterialType::dielectric) {
    if (is_opaque(material)) return {CosineLambert{material.tint}};
    return {glass_at(surface)};
  }
  if (is_polished(material)) return {polished_of(material)};
  if (material.type == MaterialType::metal) return {metal_of<Normals>(material)};
  return {plastic_of<Normals>(material)};
}
// [rough-at]

}  // namespace lt
