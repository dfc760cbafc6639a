/// @file
/// What lies under the coat, and how much light the coat leaves it: three models.
#pragma once

#include <concepts>

#include "ch08_microfacets/half_vector.hpp"
#include "ch10_dielectric/specular_albedo.hpp"

namespace lt {

// [base]
/// A matt body under a coat. Directions as in chapter 5.
///   eval(wo, wi)  its share of the BSDF, without the cosine, 1/sr: through the coat, off the body,
///                 and out again
///   share(wo)     about how much of the light it gives back to wo, 0 to 1, as one number for all
///                 colours; samplers choose by it. If it is wrong, a picture is noisier, not wrong;
///                 but where eval() is not 0, it must not be 0.
template <class T>
concept CoatedBase = requires(const T& base, vec3 wo, vec3 wi) {
  { base.eval(wo, wi) } -> std::same_as<Rgb>;
  { base.share(wo) } -> std::same_as<float>;
};
// [base]

/// The mean of the three colours.
[[nodiscard]] inline float mean_channel(Rgb color) {
  return (color.r + color.g + color.b) / 3.0f;
}

// [thesis-base]
/// Thesis eq. 7: light goes through the facet that would mirror it, in and out, so that of each
/// (1 - F) squared is left. Kept to compare with: it gives back more light than there is.
struct ThesisBase {
  Rgb albedo;  ///< 0 to 1
  CoatFresnel coat;

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const {
    if (!(wo.z > 0.0f && wi.z > 0.0f)) return Rgb(0.0f);
    const float cosine = std::clamp(dot(wo, half_vector(wo, wi)), 0.0f, 1.0f);
    const float through = 1.0f - coat.share(cosine);
    return albedo / pi * (through * through);
  }

  [[nodiscard]] float share(vec3 /*wo*/) const {
    const float through = 1.0f - coat.share(1.0f);
    return mean_channel(albedo) * through * through;
  }
};
// [thesis-base]

// [reciprocal-base]
/// Light goes in at its angle to the *surface*, and out at the other: of each 1 - F is left. What
/// the coat sends back in from below is lost, and a rough coat mirrors less than F: it is dark.
struct ReciprocalBase {
  Rgb albedo;  ///< 0 to 1
  CoatFresnel coat;

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const {
    if (!(wo.z > 0.0f && wi.z > 0.0f)) return Rgb(0.0f);
    return albedo / pi * (through(wo) * through(wi));
  }

  [[nodiscard]] float share(vec3 wo) const { return mean_channel(albedo) * through(wo); }

 private:
  [[nodiscard]] float through(vec3 w) const { return 1.0f - coat.share(std::min(w.z, 1.0f)); }
};
// [reciprocal-base]

// [conserving-base]
/// The body gets all light that the coat does not reflect, 1 - E, and a white one gives all of it
/// back: together E + albedo (1 - E). Kelemen and Szirmay-Kalos 2001.
struct ConservingBase {
  Rgb albedo;                   ///< 0 to 1
  float specular;               ///< as the coat's; scales E, too
  const SpecularAlbedo& table;  ///< of the coat; must outlive this

  [[nodiscard]] Rgb eval(vec3 wo, vec3 wi) const {
    if (!(wo.z > 0.0f && wi.z > 0.0f)) return Rgb(0.0f);
    const float through_on_average = 1.0f - specular * table.mean();
    return albedo / pi * (through(wo) * through(wi) / through_on_average);
  }

  [[nodiscard]] float share(vec3 wo) const { return mean_channel(albedo) * through(wo); }

 private:
  [[nodiscard]] float through(vec3 w) const {
    return 1.0f - specular * table.at(std::min(w.z, 1.0f));
  }
};
// [conserving-base]

static_assert(CoatedBase<ThesisBase> && CoatedBase<ReciprocalBase> && CoatedBase<ConservingBase>);

}  // namespace lt
