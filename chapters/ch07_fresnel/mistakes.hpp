/// @file
/// Mistakes to look at. The pictures of `--wrong` are made with them; nothing else uses them.
#pragma once

#include "ch07_fresnel/smooth.hpp"

namespace lt::mistakes {

// [sides-exchanged]
/// Takes the index of the side *to which* the ray goes for that of the side from which one looks.
[[nodiscard]] inline Glass glass_inside_out_at(const Surface& surface) {
  const float ior = surface.material.ior;
  return surface.outside ? Glass{ior, index_of_air} : Glass{index_of_air, ior};
}
// [sides-exchanged]

// [no-total-reflection]
/// Fresnel's equations as they are printed: nothing asks whether there is an angle beyond.
template <std::floating_point Real>
[[nodiscard]] Real fresnel_without_total_reflection(Real cos_here, Real n_here, Real n_beyond) {
  const Real eta = n_here / n_beyond;
  const Real cos_beyond = std::sqrt(squared_cos_beyond(cos_here, eta));  // NaN beyond the angle
  const Real s =
      (n_here * cos_here - n_beyond * cos_beyond) / (n_here * cos_here + n_beyond * cos_beyond);
  const Real p =
      (n_beyond * cos_here - n_here * cos_beyond) / (n_beyond * cos_here + n_here * cos_beyond);
  return (s * s + p * p) / 2;
}

/// Glass that does not know of total reflection: no comparison with NaN is true, so it refracts.
struct GlassWithoutTotalReflection : Glass {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const vec3 normal(0.0f, 0.0f, 1.0f);
    const float share = fresnel_without_total_reflection(wo.z, n_here, n_beyond);
    if (u.z < share) return delta_sample(reflected(wo, normal), Rgb(1.0f));
    const float eta = n_here / n_beyond;
    const float cos_beyond = std::sqrt(squared_cos_beyond(wo.z, eta));
    return delta_sample((eta * wo.z - cos_beyond) * normal - eta * wo, Rgb(eta * eta));
  }
};
// [no-total-reflection]

// [no-scale]
/// Takes radiance for something that passes a surface unchanged.
struct GlassWithoutScale : Glass {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    const auto right = Glass::sample(wo, u);
    return right ? std::optional(delta_sample(right->wi, Rgb(1.0f))) : right;
  }
};
// [no-scale]

// [unpaid]
/// Chooses with the probabilities F and 1 - F and multiplies by them once more.
struct GlassChosenAndWeighted : Glass {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    auto right = Glass::sample(wo, u);
    const float share = fresnel_dielectric(wo.z, n_here, n_beyond);
    if (right) right->weight *= right->wi.z > 0.0f ? share : 1.0f - share;
    return right;
  }
};
// [unpaid]

// [printed-conductor]
/// Thesis eq. 9 as printed: in the last bracket the square of the *outer* index stands where that
/// of the metal belongs.
template <std::floating_point Real>
[[nodiscard]] Real fresnel_conductor_as_printed(Real cos_here, Real n_here, Real eta, Real k) {
  const Real squared_eta = (eta / n_here) * (eta / n_here);
  const Real squared_k = (k / n_here) * (k / n_here);
  const Real squared_cos = cos_here * cos_here;
  const Real squared_sin = 1 - squared_cos;
  const Real real_part = squared_eta - squared_k - squared_sin;
  const Real length = std::sqrt(real_part * real_part + 4 * squared_eta * squared_k);
  const Real printed = 1 - squared_k - squared_sin;  // 1 is n_here / n_here; right is squared_eta
  const Real a = std::sqrt((length + printed) / 2);
  const Real b = std::sqrt((length - printed) / 2);
  const Real s = squared_length(a - cos_here, b) / squared_length(a + cos_here, b);
  const Real p = s * squared_length(a * cos_here - squared_sin, b * cos_here) /
                 squared_length(a * cos_here + squared_sin, b * cos_here);
  return (s + p) / 2;
}

struct MirrorAsPrinted : Mirror {
  [[nodiscard]] std::optional<BsdfSample> sample(vec3 wo, vec3 u) const {
    auto right = Mirror::sample(wo, u);
    if (!right) return right;
    for (int c = 0; c < 3; ++c)
      right->weight[c] =
          tint[c] * fresnel_conductor_as_printed(wo.z, index_of_air, metal.eta[c], metal.k[c]);
    return right;
  }
};
// [printed-conductor]

// [with-mistake]
/// smooth_bsdf_at() with another glass, made by `glass_from(surface)`.
template <class GlassFrom>
[[nodiscard]] auto with_glass(const GlassFrom& glass_from) {
  return [glass_from](const Surface& surface) {
    using Wrong = decltype(glass_from(surface));
    using WrongBsdf = OneOf<CosineLambert, Mirror, Wrong>;
    const SmoothBsdf right = smooth_bsdf_at(surface);
    if (std::holds_alternative<Glass>(right.kind)) return WrongBsdf{glass_from(surface)};
    if (const auto* mirror = std::get_if<Mirror>(&right.kind)) return WrongBsdf{*mirror};
    return WrongBsdf{std::get<CosineLambert>(right.kind)};
  };
}

/// smooth_bsdf_at() with mirrors as printed.
[[nodiscard]] inline auto printed_mirror_at(const Surface& surface) {
  using WrongBsdf = OneOf<CosineLambert, MirrorAsPrinted, Glass>;
  const SmoothBsdf right = smooth_bsdf_at(surface);
  if (const auto* mirror = std::get_if<Mirror>(&right.kind))
    return WrongBsdf{MirrorAsPrinted{*mirror}};
  if (const auto* glass = std::get_if<Glass>(&right.kind)) return WrongBsdf{*glass};
  return WrongBsdf{std::get<CosineLambert>(right.kind)};
}
// [with-mistake]

}  // namespace lt::mistakes
