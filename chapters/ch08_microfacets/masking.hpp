/// @file
/// Which share of the facets is seen, and which is seen and lit.
#pragma once

#include "ch05_rendering_equation/bsdf.hpp"
#include "ch08_microfacets/ggx.hpp"

namespace lt {

// [g1]
/// Masking: the share of the facets facing `h` that one sees from `w`, the others being behind
/// their neighbours. Thesis eq. 5's factor (Walter et al. 2007, eq. 34).
/// @param w  to whoever looks, unit, local frame
/// @param h  the facets' normal, unit
/// @return 0 to 1; 0 for facets that show `w` their back
[[nodiscard]] inline float g1(const Ggx& ggx, vec3 w, vec3 h) {
  if (!(dot(w, h) * w.z > 0.0f)) return 0.0f;
  return 1.0f / (1.0f + ggx.lambda(w));
}
// [g1]

// [g2-separable]
/// Masking and shadowing: the share of the facets between `wo` and `wi` that is both seen and lit,
/// as if the one had nothing to do with the other. Thesis eq. 5.
/// @param wo, wi  unit, local frame
/// @return 0 to 1; 0 unless both are on the same side
[[nodiscard]] inline float g2_separable(const Ggx& ggx, vec3 wo, vec3 wi) {
  if (!same_side(wo, wi)) return 0.0f;
  return 1.0f / ((1.0f + ggx.lambda(wo)) * (1.0f + ggx.lambda(wi)));
}
// [g2-separable]

// [g2-correlated]
/// The same for facets of which the high ones are both seen and lit more often than the low ones,
/// so that fewer are lost. The height-correlated form of Smith's model (Heitz 2014, eq. 99).
/// @param wo, wi  unit, local frame
/// @return g2_separable() to the smaller of both masking terms; 0 unless both are on the same side
[[nodiscard]] inline float g2_correlated(const Ggx& ggx, vec3 wo, vec3 wi) {
  if (!same_side(wo, wi)) return 0.0f;
  return 1.0f / (1.0f + ggx.lambda(wo) + ggx.lambda(wi));
}
// [g2-correlated]

}  // namespace lt
