/// @file
/// How much of the light a rough glass surface lets go anywhere.
#pragma once

#include "ch08_microfacets/albedo.hpp"
#include "ch11_refraction/rough_glass.hpp"

namespace lt {

// [interface-energy]
/// Of the energy that comes from `wo`: which shares are reflected and go through. The rest would
/// have met a second facet.
struct InterfaceEnergy {
  double reflected = 0;  ///< 0 to 1
  double through = 0;    ///< 0 to 1
  double unreduced = 0;  ///< what would go through if nothing were reflected: thesis eq. 17

  [[nodiscard]] double total() const { return reflected + through; }
};

/// The mean weight over a grid of all u, as in chapter 10; u.z is spent on both answers. The weight
/// of what goes through is radiance's: without the factor eta^2 it counts energy.
/// @param mu     cosine of the angle to the normal, > 0
/// @param steps  steps x steps facets
template <class RoughInterface>
[[nodiscard]] InterfaceEnergy interface_energy(const RoughInterface& glass, float mu, int steps) {
  const vec3 wo = at_cosine(mu);
  const double eta = double{glass.n_here} / double{glass.n_beyond};
  InterfaceEnergy sum;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const vec2 u = (vec2(i, j) + 0.5f) / static_cast<float>(steps);
      const vec3 h = VisibleNormals::sample(glass.ggx, wo, u);
      const double f =
          fresnel_dielectric(std::clamp(dot(wo, h), 0.0f, 1.0f), glass.n_here, glass.n_beyond);
      const auto up = glass.sample(wo, vec3(u, 0.0f));
      const auto down = glass.sample(wo, vec3(u, 1.0f - 0x1p-24f));
      if (up && up->wi.z > 0.0f) sum.reflected += f * double{up->weight.g};
      if (!down || down->wi.z > 0.0f) continue;
      sum.through += (1 - f) * double{down->weight.g} / (eta * eta);
      sum.unreduced += double{down->weight.g} / (eta * eta);
    }
  return {sum.reflected / steps / steps, sum.through / steps / steps,
          sum.unreduced / steps / steps};
}
// [interface-energy]

}  // namespace lt
