/// @file
/// What a surface is made of, as data. What light does there comes later, chapter by chapter.
#pragma once

#include <algorithm>

#include "ch01_pixels/color.hpp"

namespace lt {

// [material]
/// How light treats an object.
enum class MaterialType {
  dielectric,  ///< glass, plaster, wood: a clear or a diffuse inside under a reflecting surface
  metal,       ///< reflects at the surface, in color
  plastic      ///< the thesis' third kind: reflects as a dielectric, in color, no diffuse part
};

/// The record of an object's properties; thesis section 5.1. In brackets: the thesis' names.
struct Material {
  Rgb emission{0.0f};       ///< radiance it sends out [W / (m^2 sr)], >= 0 (emittance)
  Rgb tint{1.0f};           ///< share of light that it gives back, 0 to 1 (diffuseTint)
  float specular = 1.0f;    ///< factor on reflections at its surface, 0 to 1 (specularValue)
  float roughness = 1.0f;   ///< width alpha of the reflection, 0 mirror to 1 matt (roughness)
  float ior = 1.5f;         ///< index of refraction, >= 0; air has 1 (refractionIndex)
  Rgb attenuation{500.0f};  ///< light lost on its way through, 1/m, >= 0 (attenuation)
  float extinction = 0.0f;  ///< imaginary part k of the index, >= 0, metals (extinctionCoefficient)
  MaterialType type = MaterialType::dielectric;
};
// [material]

// [is-opaque]
/// From this attenuation on [1/m] nothing gets through: after 1 cm less than 1 % is left. The
/// thesis' convention.
inline constexpr float opaque_attenuation = 500.0f;

/// True unless light can pass through: only dielectrics can be clear.
[[nodiscard]] inline bool is_opaque(const Material& material) {
  const Rgb a = material.attenuation;
  return material.type != MaterialType::dielectric ||
         std::min({a.r, a.g, a.b}) >= opaque_attenuation;
}
// [is-opaque]

[[nodiscard]] inline bool is_emissive(const Material& material) {
  const Rgb e = material.emission;
  return std::max({e.r, e.g, e.b}) > 0.0f;
}

}  // namespace lt
