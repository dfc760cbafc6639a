/// @file
/// The thesis' metal and plastic.
#pragma once

#include "ch03_surfaces/surface.hpp"
#include "ch07_fresnel/mirror.hpp"
#include "ch08_microfacets/roughness.hpp"
#include "ch09_metal_and_plastic/rough_reflection.hpp"

namespace lt {

// [metal]
/// Thesis eq. 8, corrected: Fresnel's cosine is the one to the facet.
template <NormalSampler Normals = VisibleNormals>
using MetalReflection = RoughReflection<ConductorFresnel, Normals>;

/// A material's index and extinction are single numbers, the same for all colours: grey. The tint
/// brings the colour.
template <NormalSampler Normals = VisibleNormals>
[[nodiscard]] MetalReflection<Normals> metal_of(const Material& material) {
  const Metal grey{Rgb(material.ior), Rgb(material.extinction)};
  return {{alpha_of(material.roughness)}, {grey, material.tint}};
}
// [metal]

// [plastic]
/// Facets of a clear medium, whose reflections are tinted.
struct TintedFresnel {
  DielectricFresnel clear;
  Rgb tint;  ///< 0 to 1

  [[nodiscard]] Rgb operator()(float cosine) const { return tint * clear(cosine); }
};

/// Thesis eq. 10: no more than a tinted reflection. The colour *below* the reflection, which one
/// knows plastic by, is chapter 10's.
template <NormalSampler Normals = VisibleNormals>
using PlasticReflection = RoughReflection<TintedFresnel, Normals>;

template <NormalSampler Normals = VisibleNormals>
[[nodiscard]] PlasticReflection<Normals> plastic_of(const Material& material) {
  return {{alpha_of(material.roughness)}, {{index_of_air, material.ior}, material.tint}};
}
// [plastic]

// [polished]
/// True if a surface is so smooth that its lobe is told from a delta by nobody.
[[nodiscard]] inline bool is_polished(const Material& material) {
  return material.roughness < smallest_alpha;
}

/// Chapter 7's mirror for a polished metal or plastic. A clear medium is a metal whose extinction
/// is 0.
[[nodiscard]] inline Mirror polished_of(const Material& material) {
  const bool metal = material.type == MaterialType::metal;
  const float extinction = metal ? material.extinction : 0.0f;
  return {{Rgb(material.ior), Rgb(extinction)}, material.tint};
}
// [polished]

}  // namespace lt
