/// @file
/// BRDFs chosen at run time, for pictures and plots.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "ch08_microfacets/mistakes.hpp"

namespace lt {

// [any-brdf]
/// A BRDF that is known by its values only: f(wo, wi), 1/sr.
using AnyBrdf = std::function<Rgb(vec3 wo, vec3 wi)>;
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
  const auto with = [&](const auto& value) -> AnyBrdf {
    return [=](vec3 wo, vec3 wi) { return value(ggx, fresnel, wo, wi); };
  };
  using Fresnel = std::decay_t<decltype(fresnel)>;
  if (options.wrong == "squared") return with(m::squared_twice<Fresnel>);
  if (options.wrong == "half") return with(m::not_normalised<Fresnel>);
  if (options.wrong == "masking") return with(m::without_masking<Fresnel>);
  if (options.wrong == "four") return with(m::without_four<Fresnel>);
  if (options.wrong == "printed") return with(m::as_printed<Fresnel>);
  if (options.masking == "separable") {
    const MicrofacetReflection<Fresnel, g2_separable> brdf{ggx, fresnel};
    return [=](vec3 wo, vec3 wi) { return brdf.eval(wo, wi); };
  }
  const MicrofacetReflection brdf{ggx, fresnel};
  return [=](vec3 wo, vec3 wi) { return brdf.eval(wo, wi); };
}
// [brdf-named]

}  // namespace lt
