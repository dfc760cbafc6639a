// Rough glass to test, asked from both sides; and the same formulas in double, written from the
// paper (Walter et al. 2007) and not from the code.
#pragma once

#include <cmath>

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch05_rendering_equation/uniform_hemisphere.hpp"
#include "ch07_fresnel/tests/oracles.hpp"
#include "ch08_microfacets/tests/oracles.hpp"
#include "ch09_metal_and_plastic/tests/grid.hpp"
#include "ch11_refraction/rough_glass.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/testkit/statistics.hpp"

namespace lt::testing {

inline constexpr float glass_index = 1.5f;
inline constexpr float last = 1.0f - 0x1p-24f;  // the largest number that unit_float() makes

/// From air into glass, or from glass into air.
inline RoughGlass<> into(float alpha, float ior = glass_index) {
  return {{alpha}, 1.0f, ior};
}
inline RoughGlass<> out_of(float alpha, float ior = glass_index) {
  return {{alpha}, ior, 1.0f};
}

/// Calls f(glass, wo) at all 45 places of chapter 9's grid, from both sides.
template <class F>
void over_both_sides(const F& f) {
  over_grid([&](float alpha, vec3 wo) {
    f(into(alpha), wo);
    f(out_of(alpha), wo);
  });
}

/// A direction of the lower hemisphere, all equally likely.
inline vec3 uniform_below(vec2 u) {
  return uniform_hemisphere(u) * vec3(1.0f, 1.0f, -1.0f);
}

/// Walter et al. 2007, eq. 21 with eqs. 16, 33 and 34, for radiance (times the squared quotient of
/// the indices). Both directions as angles to the normal; phi between their azimuths.
struct Btdf {
  double alpha, n_here, n_beyond;

  double value(glm::dvec3 wo, glm::dvec3 wi) const {
    glm::dvec3 h = -(n_here * wo + n_beyond * wi);
    h /= std::sqrt(glm::dot(h, h));
    if (h.z < 0) h = -h;
    const double c_o = glm::dot(wo, h), c_i = glm::dot(wi, h);
    if (c_o <= 0 || c_i >= 0) return 0;
    const double f = complex_reflectance(c_o, n_beyond / n_here).mean();
    const double d = d_by_angle(alpha, std::acos(std::min(1.0, h.z)));
    const double g = g1_by_cosine(alpha, wo.z) * g1_by_cosine(alpha, -wi.z);
    const double sum = n_here * c_o + n_beyond * c_i;
    return c_o * -c_i / (wo.z * -wi.z) * n_here * n_here * (1 - f) * d * g / (sum * sum);
  }
};

/// The mean of one sample's weight, as energy: radiance's factor is taken out. Samples that lead
/// nowhere weigh 0.
template <class RoughInterface>
RunningMean energy_of(const RoughInterface& glass, vec3 wo, int count, std::uint64_t seed = 1) {
  Pcg32 random(seed);
  const double eta = double{glass.n_here} / double{glass.n_beyond};
  RunningMean mean;
  for (int i = 0; i < count; ++i) {
    const auto sample = glass.sample(wo, random.next_vec3());
    const double scale = sample && sample->wi.z < 0.0f ? eta * eta : 1.0;
    mean.add(sample ? double{sample->weight.g} / scale : 0.0);
  }
  return mean;
}

}  // namespace lt::testing
