/// @file
/// Mistakes to look at. The pictures of `--wrong` are made with them; nothing else uses them.
#pragma once

#include "ch09_metal_and_plastic/all_normals.hpp"
#include "ch11_refraction/complete.hpp"

namespace lt::mistakes {

// [printed-eleven]
/// Thesis eq. 11 as printed: 1 - F is multiplied by F, and the facet is the one that would *mirror*
/// the light. No such facet bends wo into wi.
[[nodiscard]] inline Rgb bent_as_printed(const RoughGlass<>& glass, vec3 wo, vec3 wi) {
  const auto& [ggx, n_here, n_beyond] = glass;
  const vec3 h_r = half_vector(wo, wi);
  const float cos_o = std::abs(dot(wo, h_r)), cos_i = std::abs(dot(wi, h_r));
  const float f = fresnel_dielectric(std::min(cos_o, 1.0f), n_here, n_beyond);
  const float sum = n_here * dot(wo, h_r) + n_beyond * dot(wi, h_r);
  const vec3 up = h_r.z < 0.0f ? -h_r : h_r;
  const float facets = ggx.d(up) * g2_through(ggx, wo, wi);
  return Rgb((1.0f - f) * f * facets * (cos_o / wo.z) * (cos_i / -wi.z) *
             (n_beyond * n_beyond / (sum * sum)));
}

/// Asked in the right directions, so that nothing but the value is wrong.
struct PrintedEleven : RoughGlass<> {
  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const {
    if (!(wi.z < 0.0f && wo.z > 0.0f)) return RoughGlass::eval(wo, wi);
    return bent_as_printed(*this, wo, wi);
  }
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    auto right = RoughGlass::sample(wo, u);
    if (right && right->wi.z < 0.0f)
      right->weight = eval(wo, right->wi) * (-right->wi.z / right->pdf);
    return right;
  }
};
// [printed-eleven]

// [fresnel-twice]
/// Half of that mistake: the right facet, and F (1 - F).
struct FresnelTwice : RoughGlass<> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    auto right = RoughGlass::sample(wo, u);
    if (!right || right->wi.z > 0.0f) return right;
    const vec3 h = transmission_half_vector(wo, right->wi, n_here, n_beyond);
    right->weight *= fresnel_dielectric(std::min(dot(wo, h), 1.0f), n_here, n_beyond);
    return right;
  }
};
// [fresnel-twice]

// [printed-sixteen]
/// Thesis eq. 16 as printed: eta where its square belongs. Not unit, and no mirror of Snell's law.
/// @return nothing where the printed root has no value
[[nodiscard]] inline std::optional<vec3> refracted_as_printed(vec3 wo, vec3 h, float eta) {
  const float c = dot(wo, h);
  const float radicand = 1.0f + eta * (c * c - 1.0f);
  if (!(radicand > 0.0f)) return std::nullopt;
  return (eta * c - std::sqrt(radicand)) * h - eta * wo;
}

/// With it, its length mended, and all else right.
struct PrintedSixteen : RoughGlass<> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    auto right = RoughGlass::sample(wo, u);
    if (!right || right->wi.z > 0.0f) return right;
    const vec3 h = VisibleNormals::sample(ggx, wo, vec2(u));
    const auto wi = refracted_as_printed(wo, h, n_here / n_beyond);
    if (!wi || !(wi->z < 0.0f)) return std::nullopt;
    return BsdfSample{normalize(*wi), right->weight, right->pdf};
  }
};
// [printed-sixteen]

// [printed-seventeen]
/// Thesis eq. 17 as printed: the weight of what is mirrored has F in it, that of what goes through
/// has nothing. Both lobes are chosen evenly and paid for; in all they give 1 + F.
struct PrintedSeventeen : RoughGlass<> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const bool is_mirrored = u.z < 0.5f;
    auto right = RoughGlass::sample(wo, {u.x, u.y, is_mirrored ? 0.0f : 1.0f});
    if (!right || is_mirrored != (right->wi.z > 0.0f)) return std::nullopt;
    const vec3 h = VisibleNormals::sample(ggx, wo, vec2(u));
    const float f = fresnel_dielectric(std::min(dot(wo, h), 1.0f), n_here, n_beyond);
    right->weight *= 2.0f * (is_mirrored ? f : 1.0f);
    return right;
  }
};
// [printed-seventeen]

// [glass-unscaled]
/// Takes radiance for something that passes a surface unchanged.
struct UnscaledGlass : RoughGlass<> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    auto right = RoughGlass::sample(wo, u);
    const float beyond_to_here = n_beyond / n_here;
    if (right && right->wi.z < 0.0f) right->weight *= beyond_to_here * beyond_to_here;
    return right;
  }
};
// [glass-unscaled]

// [glowing-glass]
/// Glass as the thesis' program had it: eqs. 15 to 17 as printed, with all facets, also those that
/// show their back; what comes through is not reduced by F, and where all is reflected it comes
/// through all the same, along the facet.
struct GlowingGlass : RoughGlass<AllNormals> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    if (!(wo.z > 0.0f)) return std::nullopt;
    const vec3 h = AllNormals::sample(ggx, wo, vec2(u));
    const float c = std::abs(dot(wo, h));
    const bool is_mirrored = u.z < 0.5f;
    const float eta = n_here / n_beyond;
    const float root = std::sqrt(std::max(0.0f, 1.0f + eta * (c * c - 1.0f)));
    const vec3 wi = normalize(is_mirrored ? 2.0f * c * h - wo : (eta * c - root) * h - eta * wo);
    if (is_mirrored != (wi.z > 0.0f)) return std::nullopt;
    const float f = fresnel_dielectric(std::min(c, 1.0f), n_here, n_beyond);
    const float weight = c * g2_through(ggx, wo, wi) / wo.z / h.z;
    return BsdfSample{wi, Rgb(2.0f * weight * (is_mirrored ? f : 1.0f)), pdf(wo, wi)};
  }
};
// [glowing-glass]

// [sides-not-exchanged]
/// Does not ask from which side the ray comes: there is always air here and glass beyond.
struct AlwaysFromAir : RoughGlass<> {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const float ior = n_here * n_beyond;  // air's index is 1
    return RoughGlass<>{ggx, index_of_air, ior}.sample(wo, u);
  }
};
// [sides-not-exchanged]

// [rough-glass-with]
/// complete_bsdf_at() with another rough glass.
template <class Wrong>
struct RoughGlassWith {
  using WrongBsdf =
      OneOf<Wrong, CosineLambert, Mirror, Glass, MetalReflection<>, PlasticReflection<>,
            CoatedDiffuse<ReciprocalBase>, PolishedDiffuse<ReciprocalBase>>;

  [[nodiscard]] WrongBsdf operator()(const Surface& surface) const {
    if (is_frosted(surface.material)) {
      const RoughGlass<> right = rough_glass_at(surface);
      return {Wrong{{right.ggx, right.n_here, right.n_beyond}}};
    }
    return std::visit([](const auto& other) { return WrongBsdf{other}; },
                      coated_bsdf_at(surface).kind);
  }
};
// [rough-glass-with]

}  // namespace lt::mistakes
