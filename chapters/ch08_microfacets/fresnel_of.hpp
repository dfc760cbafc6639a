/// @file
/// What facets are made of: how much each of them reflects, as a function of the cosine.
#pragma once

#include <concepts>

#include "ch07_fresnel/fresnel.hpp"
#include "ch07_fresnel/metals.hpp"

namespace lt {

// [fresnel-term]
/// A function from the cosine between a direction and a *facet's* normal, 0 to 1, to the share that
/// is reflected.
template <class T>
concept FresnelTerm = requires(const T& fresnel, float cosine) {
  { fresnel(cosine) } -> std::same_as<Rgb>;
};
// [fresnel-term]

// [fresnel-of]
/// Facets between two clear media.
struct DielectricFresnel {
  float n_here;    ///< index of refraction on the side of wo, > 0
  float n_beyond;  ///< index of refraction on the other side, > 0

  [[nodiscard]] Rgb operator()(float cosine) const {
    return Rgb(fresnel_dielectric(cosine, n_here, n_beyond));
  }
};

/// Facets of metal, in air.
struct ConductorFresnel {
  Metal metal;
  Rgb tint{1.0f};  ///< 0 to 1; 1 where the metal's indices bring the colour

  [[nodiscard]] Rgb operator()(float cosine) const {
    return tint * fresnel_conductor(cosine, index_of_air, metal.eta, metal.k);
  }
};

/// Facets that reflect everything: what then is missing, the model has lost.
struct PerfectMirror {
  [[nodiscard]] Rgb operator()(float /*cosine*/) const { return Rgb(1.0f); }
};
// [fresnel-of]

}  // namespace lt
