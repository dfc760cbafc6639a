/// @file
/// Reflection by facets, asked where it comes from.
#pragma once

#include <algorithm>

#include "ch07_fresnel/ideal_directions.hpp"
#include "ch08_microfacets/microfacet.hpp"
#include "ch09_metal_and_plastic/visible_normals.hpp"

namespace lt {

// [rough-reflection]
/// Chapter 8's rough surface, which chooses a facet and lets it mirror the view.
/// @tparam Fresnel  what the facets are made of
/// @tparam Normals  how a facet is chosen: VisibleNormals, or the thesis' AllNormals
/// @tparam g2       masking and shadowing: g2_correlated, or the thesis' g2_separable
template <FresnelTerm Fresnel, NormalSampler Normals = VisibleNormals, auto g2 = g2_correlated>
struct RoughReflection {
  Ggx ggx;
  Fresnel fresnel;

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const {
    return MicrofacetReflection<Fresnel, g2>{ggx, fresnel}.eval(wo, wi);
  }

  // [rough-sample]
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    if (!(wo.z > 0.0f)) return std::nullopt;
    const vec3 h = Normals::sample(ggx, wo, vec2(u));
    const float cosine = dot(wo, h);
    if (!(cosine > 0.0f)) return std::nullopt;  // one sees the facet's back

    const vec3 wi = reflected(wo, h);
    const float seen = g2(ggx, wo, wi);
    if (!(seen > 0.0f)) return std::nullopt;  // below the horizon: this light is lost

    const Rgb share = fresnel(std::min(cosine, 1.0f));
    return BsdfSample{wi, share * Normals::weight(ggx, wo, h, seen), density(wo, h, cosine)};
  }
  // [rough-sample]

  // [rough-pdf]
  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    if (!(wo.z > 0.0f && wi.z > 0.0f)) return 0.0f;
    const vec3 h = half_vector(wo, wi);
    const float cosine = dot(wo, h);
    return cosine > 0.0f ? density(wo, h, cosine) : 0.0f;
  }

 private:
  /// From a density over facets to one over directions: when h turns by an angle, wi turns by two,
  /// and in all covers 4 cos times the solid angle (Walter et al. 2007, eq. 14).
  [[nodiscard]] float density(vec3 wo, vec3 h, float cosine) const {
    return Normals::pdf(ggx, wo, h) / (4.0f * cosine);
  }
  // [rough-pdf]
};

/// So that RoughReflection{ggx, fresnel} knows its type.
template <class Fresnel>
RoughReflection(Ggx, Fresnel) -> RoughReflection<Fresnel>;
// [rough-reflection]

}  // namespace lt
