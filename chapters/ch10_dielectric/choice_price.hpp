/// @file
/// What the choice of a lobe costs in noise.
#pragma once

#include "ch10_dielectric/coated.hpp"

namespace lt {

// [weight-moments]
/// Mean and variance of a sample's weight; samples that lead nowhere weigh 0. Under an even sky of
/// radiance 1 that is what one sample of a pixel sees.
struct WeightMoments {
  double mean;
  double variance;
};

/// Over a grid of u. What u.z chooses is taken apart: p times the coat, 1 - p times the base.
/// @param bsdf   a coat over a base
/// @param steps  steps x steps values of u.x and u.y
/// @return of the green channel
template <class Coated>
[[nodiscard]] WeightMoments weight_moments(const Coated& bsdf, vec3 wo, int steps) {
  const double p = bsdf.coat_probability(wo);
  double sum = 0, sum_of_squares = 0;
  for (const bool is_coat : {true, false})
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const vec2 u = (vec2(i, j) + 0.5f) / static_cast<float>(steps);
        const auto sample = bsdf.sample(wo, vec3(u, is_coat ? 0.0f : 1.0f - 0x1p-24f));
        const double weight = sample ? double{sample->weight.g} : 0.0;
        sum += (is_coat ? p : 1 - p) * weight;
        sum_of_squares += (is_coat ? p : 1 - p) * weight * weight;
      }
  const double mean = sum / steps / steps;
  return {mean, sum_of_squares / steps / steps - mean * mean};
}
// [weight-moments]

// [grey-coated]
/// What the chapter measures the choice with: a grey body, albedo 1/2, under a coat of index 1.5.
template <LobeChoice Choice>
[[nodiscard]] CoatedDiffuse<ReciprocalBase, Choice> grey_coated(float alpha, Choice choice) {
  const CoatFresnel fresnel{1.5f};
  return {{{alpha}, fresnel}, {Rgb(0.5f), fresnel}, choice};
}
// [grey-coated]

}  // namespace lt
