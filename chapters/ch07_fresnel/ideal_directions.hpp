/// @file
/// Where a smooth surface sends a ray.
#pragma once

#include <cmath>
#include <optional>

#include "ch07_fresnel/fresnel.hpp"

namespace lt {

// [reflected]
/// The mirror image of `wo`. (The library's own reflect() wants a direction that points *to* the
/// surface: the same vector, turned round.)
/// @param wo  unit, away from the surface
/// @param h   the surface's normal, unit; dot(wo, h) > 0, or the ray would come from behind
/// @return unit, away from the surface
[[nodiscard]] inline vec3 reflected(vec3 wo, vec3 h) {
  return 2.0f * dot(wo, h) * h - wo;
}
// [reflected]

// [refracted]
/// The direction on the other side of the surface, by Snell's law.
/// @param wo   unit, away from the surface
/// @param h    the surface's normal on the side of wo, unit; dot(wo, h) > 0
/// @param eta  index of refraction on the side of wo / on the other side, > 0
/// @return unit, away from the surface; nothing where all light is reflected
[[nodiscard]] inline std::optional<vec3> refracted(vec3 wo, vec3 h, float eta) {
  const float cos_here = dot(wo, h);
  const float squared_cos = squared_cos_beyond(cos_here, eta);
  if (!(squared_cos > 0.0f)) return std::nullopt;
  return (eta * cos_here - std::sqrt(squared_cos)) * h - eta * wo;
}
// [refracted]

}  // namespace lt
