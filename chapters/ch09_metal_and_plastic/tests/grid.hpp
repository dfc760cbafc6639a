// Where the samplers are asked: nine directions, from straight above to nearly along the surface,
// at five widths.
#pragma once

#include <cmath>

#include "ch08_microfacets/albedo.hpp"
#include "ch09_metal_and_plastic/all_normals.hpp"
#include "ch09_metal_and_plastic/rough_reflection.hpp"

namespace lt::testing {

inline constexpr float grid_cosines[] = {1.0f, 0.9f, 0.7f, 0.5f, 0.3f, 0.2f, 0.1f, 0.05f, 0.02f};
inline constexpr float grid_alphas[] = {0.05f, 0.1f, 0.3f, 0.6f, 1.0f};

/// A direction whose cosine is `mu`, in no special azimuth.
inline vec3 slanting_at(float mu) {
  const float sine = std::sqrt((1.0f - mu) * (1.0f + mu));
  return {0.8f * sine, -0.6f * sine, mu};
}

/// Calls f(alpha, wo) at all 45 places.
template <class F>
void over_grid(const F& f) {
  for (const float alpha : grid_alphas)
    for (const float mu : grid_cosines)
      f(alpha, slanting_at(mu));
}

template <class Normals, auto g2 = g2_correlated>
using White = RoughReflection<PerfectMirror, Normals, g2>;

}  // namespace lt::testing
