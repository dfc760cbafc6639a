/// @file
/// BRDFs chosen at run time, for pictures and plots.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "ch08_microfacets/mistakes.hpp"

namespace lt {

// [any-brdf]
/// A BRDF that is known by its values only, f(wo, wi), and asked in proportion to the cosine.
struct AnyBrdf {
  std::function<Rgb(vec3 wo, vec3 wi)> value;

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const { return value(wo, wi); }
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const vec3 wi = cosine_hemisphere(vec2(u));
    return BsdfSample{wi, eval(wo, wi) * pi, cosine_hemisphere_pdf(wi.z)};
  }
  [[nodiscard]] float pdf(vec3 wo, vec3 wi) const {
    return same_side(wo, wi) ? cosine_hemisphere_pdf(wi.z) : 0.0f;
  }
};
// [any-brdf]

/// Which microfacet BRDF.
struct BrdfOptions {
  std::string masking = "correlated";  ///< correlated or separable
  std::string wrong = "none";          ///< a mistake: none, squared, half, masking, four, printed
};

// [brdf-named]
[[nodiscard]] inline AnyBrdf brdf_named(const BrdfOptions& options, Ggx ggx,
                                        const FresnelTerm auto& fresnel) {
  namespace m = mistakes;
  const auto with = [&](const auto& value) {
    return AnyBrdf{[=](vec3 wo, vec3 wi) { return value(ggx, fresnel, wo, wi); }};
  };
  using Fresnel = std::decay_t<decltype(fresnel)>;
  if (options.wrong == "squared") return with(m::squared_twice<Fresnel>);
  if (options.wrong == "half") return with(m::not_normalised<Fresnel>);
  if (options.wrong == "masking") return with(m::without_masking<Fresnel>);
  if (options.wrong == "four") return with(m::without_four<Fresnel>);
  if (options.wrong == "printed") return with(m::as_printed<Fresnel>);
  if (options.masking == "separable") {
    const MicrofacetReflection<Fresnel, g2_separable> brdf{ggx, fresnel};
    return {[=](vec3 wo, vec3 wi) { return brdf.eval(wo, wi); }};
  }
  const MicrofacetReflection brdf{ggx, fresnel};
  return {[=](vec3 wo, vec3 wi) { return brdf.eval(wo, wi); }};
}
// [brdf-named]

}  // namespace lt
