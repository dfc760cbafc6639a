/// @file
/// What happens at a surface: all of the thesis' materials.
#pragma once

#include <cmath>
#include <variant>

#include "ch10_dielectric/coated_bsdf.hpp"
#include "ch11_refraction/rough_glass.hpp"

namespace lt {

// [is-frosted]
/// Two indices that differ by less bend no ray that one could see, and in float their half vector
/// is noise: the honest model is chapter 7's delta.
inline constexpr float smallest_index_step = 1e-4f;

/// True for clear dielectrics whose surface is rough.
[[nodiscard]] inline bool is_frosted(const Material& material) {
  return !is_opaque(material) && !is_polished(material) &&
         std::abs(material.ior - index_of_air) >= smallest_index_step;
}
// [is-frosted]

// [rough-glass-at]
/// Which side am I on? The true surface tells, not the bumps on it: `outside` is the sign of the
/// cosine between the ray and the geometric normal. Inside, the indices are exchanged.
[[nodiscard]] inline RoughGlass<> rough_glass_at(const Surface& surface) {
  const Glass sides = glass_at(surface);
  return {{alpha_of(surface.material.roughness)}, sides.n_here, sides.n_beyond};
}
// [rough-glass-at]

// [complete-at]
using CompleteBsdf =
    OneOf<CosineLambert, Mirror, Glass, MetalReflection<>, PlasticReflection<>,
          CoatedDiffuse<ReciprocalBase>, PolishedDiffuse<ReciprocalBase>, RoughGlass<>>;

/// Chapter 10's surfaces; clear dielectrics are as rough as they say.
[[nodiscard]] inline CompleteBsdf complete_bsdf_at(const Surface& surface) {
  if (is_frosted(surface.material)) return {rough_glass_at(surface)};
  return std::visit([](const auto& other) { return CompleteBsdf{other}; },
                    coated_bsdf_at(surface).kind);
}
// [complete-at]

}  // namespace lt
