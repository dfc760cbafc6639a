/// @file
/// Mistakes to look at. The pictures of `--wrong` are made with them; nothing else uses them.
#pragma once

#include "ch08_microfacets/microfacet.hpp"

namespace lt::mistakes {

// [assembled]
/// Thesis eq. 3 from its parts.
/// @param four  the number that stands below the fraction
[[nodiscard]] inline Rgb assembled(Rgb f, float d, float g, vec3 wo, vec3 wi, float four = 4.0f) {
  if (!(wo.z > 0.0f && wi.z > 0.0f)) return Rgb(0.0f);
  return f * (d * g / (four * wo.z) / wi.z);
}
// [assembled]

// [squared-twice]
/// Squares alpha before it hands it to a D that squares it again: every lobe is too narrow, and
/// only alpha 1 is right. Masking knows nothing of it.
template <FresnelTerm Fresnel>
[[nodiscard]] Rgb squared_twice(Ggx ggx, const Fresnel& fresnel, vec3 wo, vec3 wi) {
  const vec3 h = half_vector(wo, wi);
  const float d = Ggx{ggx.alpha * ggx.alpha}.d(h);
  return assembled(fresnel(dot(wo, h)), d, g2_correlated(ggx, wo, wi), wo, wi);
}
// [squared-twice]

// [not-normalised]
/// Takes the sum for the half vector. It is 2 cos long, cos that of light and facet, and D of a
/// vector s times as long is D / s^4: 16 times too little where light comes straight, and far too
/// much where it grazes.
template <FresnelTerm Fresnel>
[[nodiscard]] Rgb not_normalised(Ggx ggx, const Fresnel& fresnel, vec3 wo, vec3 wi) {
  const vec3 h = wo + wi;
  const float cosine = dot(wo, half_vector(wo, wi));
  return assembled(fresnel(cosine), ggx.d(h), g2_correlated(ggx, wo, wi), wo, wi);
}
// [not-normalised]

// [no-masking]
/// Leaves G out: near the horizon the cosines below the fraction fall to 0 and nothing else does.
template <FresnelTerm Fresnel>
[[nodiscard]] Rgb without_masking(Ggx ggx, const Fresnel& fresnel, vec3 wo, vec3 wi) {
  const vec3 h = half_vector(wo, wi);
  return assembled(fresnel(dot(wo, h)), ggx.d(h), 1.0f, wo, wi);
}
// [no-masking]

// [no-four]
/// Forgets that a facet that turns by one degree turns the ray by two: four times as many
/// directions of light for each direction of a facet.
template <FresnelTerm Fresnel>
[[nodiscard]] Rgb without_four(Ggx ggx, const Fresnel& fresnel, vec3 wo, vec3 wi) {
  const vec3 h = half_vector(wo, wi);
  return assembled(fresnel(dot(wo, h)), ggx.d(h), g2_correlated(ggx, wo, wi), wo, wi, 1.0f);
}
// [no-four]

// [printed-d]
/// Thesis eq. 6 as printed: theta is the angle between the light's direction and the normal, not
/// that of the half vector.
template <FresnelTerm Fresnel>
[[nodiscard]] Rgb as_printed(Ggx ggx, const Fresnel& fresnel, vec3 wo, vec3 wi) {
  const float cosine = dot(wo, half_vector(wo, wi));
  return assembled(fresnel(cosine), ggx.d(wi), g2_separable(ggx, wo, wi), wo, wi);
}
// [printed-d]

}  // namespace lt::mistakes
