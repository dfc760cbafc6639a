/// @file
/// How much of the light coat and base give back together.
#pragma once

#include <string>

#include "ch10_dielectric/coated.hpp"

namespace lt {

// [base-albedo]
/// Share of the light from `wo` that a base gives back: the integral of f cos, as the mean of
/// pi f over a grid of cosine-weighted directions.
/// @param steps  steps x steps directions
/// @return of the green channel
template <CoatedBase Base>
[[nodiscard]] double base_albedo(const Base& base, vec3 wo, int steps) {
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const vec2 u = (vec2(i, j) + 0.5f) / static_cast<float>(steps);
      sum += double{pi} * base.eval(wo, cosine_hemisphere(u)).g;
    }
  return sum / steps / steps;
}
// [base-albedo]

// [total-albedo]
/// Both lobes together; more than 1 is light from nowhere.
/// @tparam g2        the coat's masking and shadowing
/// @param roughness  of the coat; below smallest_alpha it is polished
template <auto g2 = g2_correlated, CoatedBase Base>
[[nodiscard]] double total_albedo(CoatFresnel coat, const Base& base, float roughness, float mu,
                                  int steps) {
  const vec3 wo(std::sqrt((1.0f - mu) * (1.0f + mu)), 0.0f, mu);
  const double below = base_albedo(base, wo, steps);
  if (roughness < smallest_alpha) return double{coat.share(mu)} + below;
  return specular_albedo(Coat<g2>{{roughness}, coat}, mu, steps) + below;
}
// [total-albedo]

/// total_albedo() of a white base under a coat of index 1.5. The thesis' model has its G, too.
/// @param base  thesis, reciprocal or conserving
[[nodiscard]] inline double white_total(const std::string& base, float roughness, float mu,
                                        int steps) {
  const CoatFresnel coat{1.5f};
  const Rgb white(1.0f);
  if (base == "thesis")
    return total_albedo<g2_separable>(coat, ThesisBase{white, coat}, roughness, mu, steps);
  if (base == "reciprocal")
    return total_albedo(coat, ReciprocalBase{white, coat}, roughness, mu, steps);
  const SpecularAlbedo table(roughness, coat.ior);
  return total_albedo(coat, ConservingBase{white, 1.0f, table}, roughness, mu, steps);
}

}  // namespace lt
