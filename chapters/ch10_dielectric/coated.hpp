/// @file
/// Specular over diffuse: a BSDF of two lobes.
#pragma once

#include "ch06_importance_sampling/cosine_hemisphere.hpp"
#include "ch07_fresnel/delta.hpp"
#include "ch10_dielectric/base.hpp"
#include "ch10_dielectric/lobe_choice.hpp"

namespace lt {

// [coated]
/// A matt body under a rough clear coat: the thesis' opaque dielectric, eq. 3 over eq. 7.
/// @tparam Base    what lies below
/// @tparam Choice  how a lobe is chosen
/// @tparam g2      the coat's masking and shadowing
template <CoatedBase Base, LobeChoice Choice = ByShare, auto g2 = g2_correlated>
struct CoatedDiffuse {
  Coat<g2> coat;
  Base base;
  Choice choice{};

  // [coated-eval]
  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const { return coat.eval(wo, wi) + base.eval(wo, wi); }
  // [coated-eval]

  // [coated-sample]
  /// Chooses a lobe by u.z and a direction by the other two. Either lobe could have proposed that
  /// direction: f is the sum of both, and the density is, too.
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    if (!(wo.z > 0.0f)) return std::nullopt;
    const auto wi = u.z < coat_probability(wo) ? mirrored(wo, u) : cosine_hemisphere(vec2(u));
    if (!wi) return std::nullopt;
    const float density = pdf(wo, *wi);  // not 0: one of both lobes has just proposed wi
    return BsdfSample{*wi, eval(wo, *wi) * (wi->z / density), density};
  }
  // [coated-sample]

  // [coated-pdf]
  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    if (!(wo.z > 0.0f && wi.z > 0.0f)) return 0.0f;
    const float p = coat_probability(wo);
    return p * coat.pdf(wo, wi) + (1.0f - p) * cosine_hemisphere_pdf(wi.z);
  }

  /// @return 0 to 1; the base is chosen with what is left of 1
  [[nodiscard]] float coat_probability(vec3 wo) const {
    return choice(coat.fresnel.share(std::min(wo.z, 1.0f)), base.share(wo));
  }
  // [coated-pdf]

 private:
  /// A direction that the coat proposes.
  [[nodiscard]] std::optional<vec3> mirrored(vec3 wo, vec3 u) const {
    const auto sample = coat.sample(wo, u);
    return sample ? std::optional(sample->wi) : std::nullopt;
  }
};
// [coated]

// [polished-coat]
/// The same under a coat as smooth as glass. Its reflection is a delta: no other lobe can propose
/// that direction, and each lobe pays for its own probability alone.
template <CoatedBase Base, LobeChoice Choice = ByShare>
struct PolishedDiffuse {
  CoatFresnel coat;
  Base base;
  Choice choice{};

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const { return base.eval(wo, wi); }

  // [polished-sample]
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    if (!(wo.z > 0.0f)) return std::nullopt;
    const float p = coat_probability(wo);
    if (u.z < p)
      return delta_sample(reflected(wo, {0.0f, 0.0f, 1.0f}), coat(std::min(wo.z, 1.0f)) / p);
    const vec3 wi = cosine_hemisphere(vec2(u));
    return BsdfSample{wi, base.eval(wo, wi) * pi / (1.0f - p),
                      (1.0f - p) * cosine_hemisphere_pdf(wi.z)};
  }
  // [polished-sample]

  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    if (!(wo.z > 0.0f && wi.z > 0.0f)) return 0.0f;
    return (1.0f - coat_probability(wo)) * cosine_hemisphere_pdf(wi.z);
  }

  [[nodiscard]] float coat_probability(vec3 wo) const {
    return choice(coat.share(std::min(wo.z, 1.0f)), base.share(wo));
  }
};
// [polished-coat]

}  // namespace lt
