/// @file
/// Polished metal.
#pragma once

#include "ch07_fresnel/delta.hpp"
#include "ch07_fresnel/ideal_directions.hpp"
#include "ch07_fresnel/metals.hpp"

namespace lt {

// [mirror]
/// A smooth metal in air.
struct Mirror {
  Metal metal;
  Rgb tint{1.0f};  ///< 0 to 1; 1 where the metal's indices bring the colour

  [[nodiscard]] Rgb eval(vec3 /*wo*/, vec3 /*wi*/) const { return Rgb(0.0f); }

  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 /*u*/) const {
    if (!(wo.z > 0.0f)) return std::nullopt;
    const Rgb share = fresnel_conductor(wo.z, index_of_air, metal.eta, metal.k);
    return delta_sample(reflected(wo, {0.0f, 0.0f, 1.0f}), tint * share);
  }

  [[nodiscard]] float pdf(vec3 /*wo*/, vec3 /*wi*/) const { return 0.0f; }
};
// [mirror]

}  // namespace lt
