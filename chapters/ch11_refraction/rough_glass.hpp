/// @file
/// Frosted glass: a rough surface between two clear media.
#pragma once

#include <algorithm>

#include "ch09_metal_and_plastic/rough_reflection.hpp"
#include "ch11_refraction/bend.hpp"

namespace lt {

// [g2-through]
/// Masking and shadowing of light that goes through: the share of the facets between `wo` above and
/// `wi` below that is both seen and lit, as if the one had nothing to do with the other. (Strictly,
/// facets that are well seen from above are the less well lit from below; Heitz et al. 2016 have
/// the form with that correlation, a beta function. The difference is small, and darker.)
/// @param wo, wi  unit, local frame, on different sides
/// @return 0 to 1
[[nodiscard]] inline float g2_through(const Ggx& ggx, vec3 wo, vec3 wi) {
  return 1.0f / ((1.0f + ggx.lambda(wo)) * (1.0f + ggx.lambda(wi)));
}
// [g2-through]

// [rough-glass]
/// A rough surface whose facets are smooth glass: each reflects the share F and bends the rest.
/// Light that would meet a second facet is lost. Walter et al. 2007, eqs. 20 and 21.
/// @tparam Normals  how a facet is chosen: VisibleNormals, or the thesis' AllNormals
/// @tparam g2       masking and shadowing of reflections: g2_correlated or g2_separable
template <NormalSampler Normals = VisibleNormals, auto g2 = g2_correlated>
struct RoughGlass {
  Ggx ggx;
  float n_here;    ///< index of refraction on the side of wo, > 0
  float n_beyond;  ///< on the other side, > 0; must differ, or there is nothing to bend at

  // [rough-glass-eval]
  /// For radiance, which comes from wi and goes to wo.
  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const {
    if (wi.z > 0.0f) return reflection().eval(wo, wi);
    const auto bend = bend_between(wo, wi, n_here, n_beyond);
    if (!bend) return Rgb(0.0f);
    const float through = 1.0f - share(bend->cos_here);
    const float facets = ggx.d(bend->h) * g2_through(ggx, wo, wi);
    const float squeeze = n_here / bent_length(*bend, n_here, n_beyond);
    // One factor after the other: what two tiny cosines divide may be too large for a float.
    const float seen = through * facets * bend->cos_here / wo.z;
    return Rgb(seen * bend->cos_beyond / -wi.z * squeeze * squeeze);
  }
  // [rough-glass-eval]

  // [rough-glass-sample]
  /// Chooses a facet by u.x and u.y, and by u.z whether it reflects: with the probability F, so
  /// that no weight has F in it.
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    if (!(wo.z > 0.0f)) return std::nullopt;
    const vec3 h = Normals::sample(ggx, wo, vec2(u));
    const float cosine = dot(wo, h);
    if (!(cosine > 0.0f)) return std::nullopt;  // one sees the facet's back
    return u.z < share(cosine) ? mirrored(wo, h, cosine) : bent(wo, h, cosine);
  }
  // [rough-glass-sample]

 private:
  // [rough-glass-ways]
  [[nodiscard]] std::optional<BsdfSample> mirrored(vec3 wo, vec3 h, float cosine) const {
    const vec3 wi = reflected(wo, h);
    const float seen = g2(ggx, wo, wi);
    if (!(seen > 0.0f)) return std::nullopt;  // below the horizon: this light is lost
    return BsdfSample{wi, Rgb(Normals::weight(ggx, wo, h, seen)), mirrored_pdf(wo, h, cosine)};
  }

  [[nodiscard]] std::optional<BsdfSample> bent(vec3 wo, vec3 h, float cosine) const {
    const float eta = n_here / n_beyond;
    const auto wi = refracted(wo, h, eta);
    if (!wi || !(wi->z < 0.0f)) return std::nullopt;  // bent up again: this light is lost
    const float seen = g2_through(ggx, wo, *wi);
    if (!(seen > 0.0f)) return std::nullopt;
    const float weight = eta * eta * Normals::weight(ggx, wo, h, seen);
    return BsdfSample{*wi, Rgb(weight), bent_pdf(wo, {h, cosine, -dot(*wi, h)})};
  }
  // [rough-glass-ways]

 public:
  // [rough-glass-pdf]
  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    if (!(wo.z > 0.0f)) return 0.0f;
    if (wi.z > 0.0f) {
      const vec3 h = half_vector(wo, wi);
      const float cosine = dot(wo, h);
      return cosine > 0.0f ? mirrored_pdf(wo, h, cosine) : 0.0f;
    }
    const auto bend = bend_between(wo, wi, n_here, n_beyond);
    return bend ? bent_pdf(wo, *bend) : 0.0f;
  }

 private:
  /// When h turns by an angle, a mirrored ray turns by two, and a bent one as its facet does.
  [[nodiscard]] float mirrored_pdf(vec3 wo, vec3 h, float cosine) const {
    return share(cosine) * Normals::pdf(ggx, wo, h) / (4.0f * cosine);
  }
  [[nodiscard]] float bent_pdf(vec3 wo, const Bend& bend) const {
    return (1.0f - share(bend.cos_here)) * Normals::pdf(ggx, wo, bend.h) *
           facets_per_bent_ray(bend, n_here, n_beyond);
  }
  // [rough-glass-pdf]

  [[nodiscard]] float share(float cosine) const {
    return fresnel_dielectric(std::min(cosine, 1.0f), n_here, n_beyond);
  }
  [[nodiscard]] RoughReflection<DielectricFresnel, Normals, g2> reflection() const {
    return {ggx, {n_here, n_beyond}};
  }
};
// [rough-glass]

}  // namespace lt
