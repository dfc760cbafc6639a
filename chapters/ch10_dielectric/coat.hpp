/// @file
/// The clear coat: a rough surface of a clear medium, with something matt below it.
#pragma once

#include "ch09_metal_and_plastic/rough_reflection.hpp"

namespace lt {

// [coat]
/// What the facets of a coat reflect; the coat lies in air.
struct CoatFresnel {
  float ior;              ///< index of refraction of the coat, > 0
  float specular = 1.0f;  ///< factor on all reflections, 0 to 1; what is not reflected goes in

  /// @param cosine  of the angle to a normal, 0 to 1
  /// @return 0 to 1
  [[nodiscard]] float share(float cosine) const {
    return specular * fresnel_dielectric(cosine, index_of_air, ior);
  }
  [[nodiscard]] Rgb operator()(float cosine) const { return Rgb(share(cosine)); }
};

/// Reflection at a rough coat. Its sampler is chapter 9's.
/// @tparam g2  masking and shadowing: g2_correlated, or the thesis' g2_separable
template <auto g2 = g2_correlated>
using Coat = RoughReflection<CoatFresnel, VisibleNormals, g2>;
// [coat]

}  // namespace lt
