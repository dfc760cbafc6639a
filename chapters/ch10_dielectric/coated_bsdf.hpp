/// @file
/// What happens at a surface, as far as the course has come: opaque dielectrics wear their coat.
#pragma once

#include <variant>

#include "ch09_metal_and_plastic/rough.hpp"
#include "ch10_dielectric/coated.hpp"

namespace lt {

// [is-coated]
/// True for opaque dielectrics, unless nothing is reflected at their surface.
[[nodiscard]] inline bool is_coated(const Material& material) {
  return material.type == MaterialType::dielectric && is_opaque(material) &&
         material.specular > 0.0f;
}

/// What the coat's facets reflect.
[[nodiscard]] inline CoatFresnel coat_of(const Material& material) {
  return {material.ior, material.specular};
}
// [is-coated]

// [coated-at]
template <CoatedBase Base>
using CoatedBsdf = OneOf<CosineLambert, Mirror, Glass, MetalReflection<>, PlasticReflection<>,
                         CoatedDiffuse<Base>, PolishedDiffuse<Base>>;

// [coated-with]
/// Chapter 9's surfaces; opaque dielectrics are matt bodies under a rough coat, or under a polished
/// one. A thin wall has it on both sides.
/// @param base_of  function from a Material to what lies under its coat
template <class BaseOf>
[[nodiscard]] auto coated_with(const BaseOf& base_of, const Surface& surface) {
  const Material& material = surface.material;
  using Base = decltype(base_of(material));
  if (!is_coated(material))
    return std::visit([](const auto& other) { return CoatedBsdf<Base>{other}; },
                      rough_bsdf_at(surface).kind);
  const CoatFresnel fresnel = coat_of(material);
  if (is_polished(material))
    return CoatedBsdf<Base>{PolishedDiffuse<Base>{fresnel, base_of(material)}};
  const Coat<> coat{{alpha_of(material.roughness)}, fresnel};
  return CoatedBsdf<Base>{CoatedDiffuse<Base>{coat, base_of(material)}};
}
// [coated-with]

/// The course's choice from here on: bases that are reciprocal and create no light.
[[nodiscard]] inline CoatedBsdf<ReciprocalBase> coated_bsdf_at(const Surface& surface) {
  const auto base_of = [](const Material& material) {
    return ReciprocalBase{material.tint, coat_of(material)};
  };
  return coated_with(base_of, surface);
}
// [coated-at]

}  // namespace lt
