/// @file
/// Clear glass.
#pragma once

#include "ch03_surfaces/surface.hpp"
#include "ch07_fresnel/delta.hpp"
#include "ch07_fresnel/ideal_directions.hpp"

namespace lt {

// [glass]
/// A smooth surface between two clear media. It reflects the share F and lets 1 - F through; a
/// sample does one or the other, with just these probabilities, so that its weight has neither.
struct Glass {
  float n_here;    ///< index of refraction on the side of wo, > 0
  float n_beyond;  ///< index of refraction on the other side, > 0

  [[nodiscard]] Rgb eval(vec3 /*wo*/, vec3 /*wi*/) const { return Rgb(0.0f); }

  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    if (!(wo.z > 0.0f)) return std::nullopt;
    const vec3 normal(0.0f, 0.0f, 1.0f);
    const float share = fresnel_dielectric(wo.z, n_here, n_beyond);
    if (u.z < share) return delta_sample(reflected(wo, normal), Rgb(1.0f));

    const float eta = n_here / n_beyond;
    const auto wi = refracted(wo, normal, eta);
    if (!wi) return std::nullopt;
    return delta_sample(*wi, Rgb(eta * eta));  // radiance is squeezed into fewer directions
  }

  [[nodiscard]] float pdf(vec3 /*wo*/, vec3 /*wi*/) const { return 0.0f; }
};
// [glass]

// [glass-at]
/// Which index is which: the ray that hit the surface from outside came through air.
[[nodiscard]] inline Glass glass_at(const Surface& surface) {
  const float ior = surface.material.ior;
  return surface.outside ? Glass{index_of_air, ior} : Glass{ior, index_of_air};
}
// [glass-at]

}  // namespace lt
