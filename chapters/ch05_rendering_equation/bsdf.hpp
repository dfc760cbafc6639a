/// @file
/// What a surface does with light: the form that every material of the course has.
#pragma once

#include <concepts>
#include <optional>

#include "ch01_pixels/color.hpp"

namespace lt {

// [bsdf-sample]
/// A direction that a BSDF proposes.
struct BsdfSample {
  vec3 wi;     ///< unit, local frame
  Rgb weight;  ///< eval(wo, wi) |cos theta_i| / pdf: what radiance from wi is multiplied by
  float pdf;   ///< density of wi, 1/sr
};
// [bsdf-sample]

// [bsdf]
/// A BSDF at one point. Directions are unit, point away from the surface and are given in the local
/// frame, z along the shading normal: `wo` to the previous vertex of the path (the camera's side,
/// with z > 0), `wi` to the next one (the light's side).
///   eval(wo, wi)   the BSDF f, without the cosine, 1/sr
///   sample(wo, u)  a direction made from three numbers in [0, 1); nothing if u leads nowhere
///   pdf(wo, wi)    density with which sample() proposes wi, 1/sr
template <class T>
concept Bsdf = requires(const T& bsdf, vec3 wo, vec3 wi, vec3 u) {
  { bsdf.eval(wo, wi) } -> std::same_as<Rgb>;
  { bsdf.sample(wo, u) } -> std::same_as<std::optional<BsdfSample>>;
  { bsdf.pdf(wo, wi) } -> std::same_as<float>;
};
// [bsdf]

/// True if both directions (local frame) lie on the same side of the surface.
[[nodiscard]] inline bool same_side(vec3 a, vec3 b) {
  return a.z * b.z > 0.0f;
}

}  // namespace lt
