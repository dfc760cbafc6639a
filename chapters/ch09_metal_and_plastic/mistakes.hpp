/// @file
/// Mistakes to look at. The pictures of `--wrong` are made with them; nothing else uses them.
#pragma once

#include "ch09_metal_and_plastic/all_normals.hpp"
#include "ch09_metal_and_plastic/rough.hpp"

namespace lt::mistakes {

// [by-all]
/// What is right about all of them: chapter 8's surface, whose facets are chosen among all.
template <FresnelTerm Fresnel>
using ByAllNormals = RoughReflection<Fresnel, AllNormals>;

/// A sample whose weight is worked out from its parts, f cos / p, with whatever density is given.
template <FresnelTerm Fresnel, class Density>
[[nodiscard]] std::optional<BsdfSample> with_density(const ByAllNormals<Fresnel>& right, vec3 wo,
                                                     vec3 u, const Density& density) {
  const auto sample = right.sample(wo, u);
  if (!sample) return std::nullopt;
  const float p = density(sample->wi);
  return BsdfSample{sample->wi, right.eval(wo, sample->wi) * sample->wi.z / p, p};
}
// [by-all]

// [no-jacobian]
/// Takes the density of the facet for that of the direction.
template <FresnelTerm Fresnel>
struct JacobianForgotten : ByAllNormals<Fresnel> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    return with_density(*this, wo, u, [&](vec3 wi) { return pdf(wo, wi); });
  }
  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    const vec3 h = half_vector(wo, wi);
    return dot(wo, h) > 0.0f && wi.z > 0.0f ? AllNormals::pdf(this->ggx, wo, h) : 0.0f;
  }
};
// [no-jacobian]

// [wrong-cosine]
/// Divides by four times the cosine to the surface's normal, not to the facet's.
template <FresnelTerm Fresnel>
struct JacobianAtSurface : ByAllNormals<Fresnel> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    return with_density(*this, wo, u, [&](vec3 wi) { return pdf(wo, wi); });
  }
  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    const vec3 h = half_vector(wo, wi);
    if (!(dot(wo, h) > 0.0f && wi.z > 0.0f)) return 0.0f;
    return AllNormals::pdf(this->ggx, wo, h) / (4.0f * wo.z);
  }
};
// [wrong-cosine]

// [redrawn]
/// Does not accept that a sample may lead nowhere, and tries until one does.
template <FresnelTerm Fresnel>
struct Redrawn : ByAllNormals<Fresnel> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    for (int i = 0; i < 100; ++i) {
      if (const auto found = ByAllNormals<Fresnel>::sample(wo, u)) return found;
      u = glm::fract(u * 97.0f + 0.123f);  // other numbers, as good as new ones for this purpose
    }
    return std::nullopt;
  }
};
// [redrawn]

// [paid-twice]
/// Takes eq. 17's weight, in which the density has been cancelled, and divides by it once more.
template <FresnelTerm Fresnel>
struct PaidTwice : ByAllNormals<Fresnel> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    auto sample = ByAllNormals<Fresnel>::sample(wo, u);
    if (sample) sample->weight /= sample->pdf;
    return sample;
  }
};
// [paid-twice]

// [fresnel-at-surface]
/// Thesis eq. 8 as printed: Fresnel's cosine is the one to the surface's normal. Exchange light and
/// camera, and the value is another.
template <FresnelTerm Fresnel>
struct FresnelAtSurface : ByAllNormals<Fresnel> {
  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const {
    if (!(wo.z > 0.0f)) return Rgb(0.0f);
    const MicrofacetReflection white{this->ggx, PerfectMirror{}};
    return this->fresnel(wo.z) * white.eval(wo, wi);
  }
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const RoughReflection<PerfectMirror, AllNormals> white{this->ggx, {}};
    auto sample = white.sample(wo, u);
    if (sample) sample->weight *= this->fresnel(wo.z);
    return sample;
  }
};
// [fresnel-at-surface]

// [angles-exchanged]
/// Thesis eqs. 13 and 14 by their words: theta is called the azimuth, phi the angle to the zenith.
template <FresnelTerm Fresnel>
struct AnglesExchanged : ByAllNormals<Fresnel> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const float theta = std::atan(this->ggx.alpha * std::sqrt(u.x / (1.0f - u.x)));
    const float phi = 2.0f * pi * u.y;
    const vec3 h(std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta), std::cos(phi));
    if (!(h.z > 0.0f && dot(wo, h) > 0.0f)) return std::nullopt;
    const vec3 wi = reflected(wo, h);
    const float seen = g2_correlated(this->ggx, wo, wi);
    if (!(seen > 0.0f)) return std::nullopt;
    const Rgb share = this->fresnel(std::min(dot(wo, h), 1.0f));
    const Rgb weight = share * AllNormals::weight(this->ggx, wo, h, seen);
    return BsdfSample{wi, weight, this->pdf(wo, wi)};
  }
};
// [angles-exchanged]

// [absolute-value]
/// Thesis eq. 15 as printed. For a facet that shows its back, c = wo.h < 0, it is no mirror image;
/// its squared length is 1 + 8 c^2.
[[nodiscard]] inline vec3 reflected_as_printed(vec3 wo, vec3 h) {
  return 2.0f * std::abs(dot(wo, h)) * h - wo;
}

/// Thesis eqs. 15 and 17 as printed, without a word on facets that show their back. The length is
/// mended, or nothing could be traced; the direction is still wrong.
template <FresnelTerm Fresnel>
struct AbsoluteValue : ByAllNormals<Fresnel> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    if (!(wo.z > 0.0f)) return std::nullopt;
    const vec3 h = AllNormals::sample(this->ggx, wo, vec2(u));
    const float cosine = std::abs(dot(wo, h));
    const vec3 wi = normalize(reflected_as_printed(wo, h));
    const float seen = g2_correlated(this->ggx, wo, wi);
    if (!(seen > 0.0f)) return std::nullopt;
    const Rgb share = this->fresnel(std::min(cosine, 1.0f));
    return BsdfSample{wi, share * (seen * cosine / wo.z / h.z), this->pdf(wo, wi)};
  }
};
// [absolute-value]

// [rough-with]
/// rough_bsdf_at() with another metal and plastic.
template <template <class Fresnel> class Wrong>
struct RoughWith {
  using WrongBsdf =
      OneOf<CosineLambert, Mirror, Glass, Wrong<ConductorFresnel>, Wrong<TintedFresnel>>;

  [[nodiscard]] WrongBsdf operator()(const Surface& surface) const {
    const RoughBsdf<AllNormals> right = rough_bsdf_at<AllNormals>(surface);
    if (const auto* metal = std::get_if<MetalReflection<AllNormals>>(&right.kind))
      return {Wrong<ConductorFresnel>{*metal}};
    if (const auto* plastic = std::get_if<PlasticReflection<AllNormals>>(&right.kind))
      return {Wrong<TintedFresnel>{*plastic}};
    if (const auto* mirror = std::get_if<Mirror>(&right.kind)) return {*mirror};
    if (const auto* glass = std::get_if<Glass>(&right.kind)) return {*glass};
    return {std::get<CosineLambert>(right.kind)};
  }
};
// [rough-with]

}  // namespace lt::mistakes
