/// @file
/// Which facets bend one direction into another, and how far a bent ray turns with its facet.
#pragma once

#include <optional>

#include "ch08_microfacets/half_vector.hpp"

namespace lt {

// [transmission-half-vector]
/// The normal of the facets that bend light between `wo` and `wi`, turned up. By Snell's law the
/// parts of n_here wo and n_beyond wi along the facet cancel; what is left of their sum lies along
/// its normal. The sum points into the medium with the larger index (Walter et al. 2007, eq. 16,
/// has it with a minus).
/// @param wo, wi            unit, local frame, away from the surface
/// @param n_here, n_beyond  indices of refraction on the sides of wo and of wi, > 0
/// @return unit, z >= 0; the null vector where the sum vanishes: no facet does it
[[nodiscard]] inline vec3 transmission_half_vector(vec3 wo, vec3 wi, float n_here, float n_beyond) {
  const vec3 h = half_vector(n_here * wo, n_beyond * wi);
  return h.z < 0.0f ? -h : h;
}
// [transmission-half-vector]

// [bend]
/// How light is bent at a facet.
struct Bend {
  vec3 h;            ///< the facet's normal, unit, local frame, z > 0
  float cos_here;    ///< of the angle between wo and h, > 0
  float cos_beyond;  ///< of the angle between wi and h on the other side, as a positive number
};

/// The facets between two directions.
/// @return nothing unless wi is below, wo in front of the facet and wi behind it
[[nodiscard]] inline std::optional<Bend> bend_between(vec3 wo, vec3 wi, float n_here,
                                                      float n_beyond) {
  if (!(wo.z > 0.0f && wi.z < 0.0f)) return std::nullopt;
  const vec3 h = transmission_half_vector(wo, wi, n_here, n_beyond);
  const Bend bend{h, dot(wo, h), -dot(wi, h)};
  if (!(bend.cos_here > 0.0f && bend.cos_beyond > 0.0f)) return std::nullopt;
  return bend;
}
// [bend]

// [bent-length]
/// How long n_here wo + n_beyond wi is, with a sign: n_here cos_here - n_beyond cos_beyond. By
/// Snell's law that is the same as this quotient, which subtracts nothing that is nearly equal.
[[nodiscard]] inline float bent_length(const Bend& bend, float n_here, float n_beyond) {
  return (n_here - n_beyond) * (n_here + n_beyond) /
         (n_here * bend.cos_here + n_beyond * bend.cos_beyond);
}

/// Solid angle of facets for each unit of solid angle of bent rays, d(omega_h) / d(omega_i); Walter
/// et al. 2007, eq. 17.
[[nodiscard]] inline float facets_per_bent_ray(const Bend& bend, float n_here, float n_beyond) {
  const float per_length = n_beyond / bent_length(bend, n_here, n_beyond);
  return bend.cos_beyond * per_length * per_length;
}
// [bent-length]

}  // namespace lt
