/// @file
/// Reflection by facets too small to be seen.
#pragma once

#include <algorithm>

#include "ch05_rendering_equation/bsdf.hpp"
#include "ch06_importance_sampling/cosine_hemisphere.hpp"
#include "ch08_microfacets/fresnel_of.hpp"
#include "ch08_microfacets/half_vector.hpp"
#include "ch08_microfacets/masking.hpp"

namespace lt {

// [microfacet]
/// A rough surface: many small mirrors, of which those between `wo` and `wi` pass the light on.
/// Torrance and Sparrow 1967; thesis eq. 3 (Walter et al. 2007, eq. 20). Light that would meet a
/// second facet is lost.
/// @tparam Fresnel  what the facets are made of
/// @tparam g2       masking and shadowing: g2_correlated, or the thesis' g2_separable
template <FresnelTerm Fresnel, auto g2 = g2_correlated>
struct MicrofacetReflection {
  Ggx ggx;
  Fresnel fresnel;

  // [microfacet-eval]
  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const {
    if (!(wo.z > 0.0f && wi.z > 0.0f)) return Rgb(0.0f);
    const vec3 h = half_vector(wo, wi);
    const float cosine = std::clamp(dot(wo, h), 0.0f, 1.0f);
    // One division after the other: the product of two tiny cosines may be 0.
    return fresnel(cosine) * (ggx.d(h) * g2(ggx, wo, wi) / (4.0f * wo.z) / wi.z);
  }
  // [microfacet-eval]

  // [microfacet-sample]
  /// Asks in proportion to the cosine, wherever the lobe may be: as good as it gets for alpha 1,
  /// and ever noisier below.
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const vec3 wi = cosine_hemisphere(vec2(u));
    return BsdfSample{wi, eval(wo, wi) * pi, cosine_hemisphere_pdf(wi.z)};
  }

  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    return same_side(wo, wi) ? cosine_hemisphere_pdf(wi.z) : 0.0f;
  }
  // [microfacet-sample]
};

/// So that MicrofacetReflection{ggx, fresnel} knows its type.
template <class Fresnel>
MicrofacetReflection(Ggx, Fresnel) -> MicrofacetReflection<Fresnel>;
// [microfacet]

}  // namespace lt
