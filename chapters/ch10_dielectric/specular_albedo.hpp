/// @file
/// How much of the light a coat reflects in all, from each angle: computed once, then looked up.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "ch08_microfacets/roughness.hpp"
#include "ch10_dielectric/coat.hpp"

namespace lt {

// [specular-albedo]
/// E(mu): share of the light from `wo` that a rough surface reflects anywhere. A sample's weight is
/// f cos / pdf, so the mean weight is the integral of f cos: no estimate here, but the mean over a
/// grid of all u.
/// @param surface  a Bsdf with one lobe, for which u.z does not count
/// @param mu       cosine of the angle to the normal, > 0
/// @param steps    steps x steps values of u
/// @return of the green channel; 0 to 1
template <Bsdf Reflection>
[[nodiscard]] double specular_albedo(const Reflection& surface, float mu, int steps) {
  const vec3 wo(std::sqrt((1.0f - mu) * (1.0f + mu)), 0.0f, mu);
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const vec2 u = (vec2(i, j) + 0.5f) / static_cast<float>(steps);
      if (const auto sample = surface.sample(wo, vec3(u, 0.5f))) sum += double{sample->weight.g};
    }
  return sum / steps / steps;
}
// [specular-albedo]

// [albedo-table]
/// E of a coat at 65 cosines, to look up between. They lie closer where E is steep: mu = t^2, with
/// equal steps of t.
class SpecularAlbedo {
 public:
  // [albedo-table-make]
  /// Takes about ten milliseconds.
  /// @param roughness  of the coat; below smallest_alpha it is polished, and E is Fresnel's share
  /// @param ior        of the coat, > 0
  SpecularAlbedo(float roughness, float ior) {
    const CoatFresnel fresnel{ior};
    const Coat<> coat{{roughness}, fresnel};
    for (int i = 0; i <= intervals; ++i) {
      const float t = static_cast<float>(i) / intervals;
      const float mu = std::max(t * t, 1e-6f);  // at 0 nothing is seen at all
      const bool is_polished = roughness < smallest_alpha;
      albedos_[i] =
          is_polished ? fresnel.share(mu) : static_cast<float>(specular_albedo(coat, mu, 64));
    }
    mean_ = mean_over_cosine();
  }
  // [albedo-table-make]

  /// @param mu  0 to 1
  [[nodiscard]] float at(float mu) const {
    const float place = std::sqrt(mu) * intervals;
    const int i = std::min(static_cast<int>(place), intervals - 1);
    return glm::mix(albedos_[i], albedos_[i + 1], place - static_cast<float>(i));
  }

  /// The share of light that comes from everywhere alike: the integral of 2 E mu over mu.
  [[nodiscard]] float mean() const { return mean_; }

 private:
  static constexpr int intervals = 64;

  [[nodiscard]] float mean_over_cosine() const {
    constexpr int steps = 4096;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      const float mu = (static_cast<float>(i) + 0.5f) / steps;
      sum += 2.0 * at(mu) * mu;
    }
    return static_cast<float>(sum / steps);
  }

  std::array<float, intervals + 1> albedos_{};
  float mean_ = 0.0f;
};
// [albedo-table]

}  // namespace lt
