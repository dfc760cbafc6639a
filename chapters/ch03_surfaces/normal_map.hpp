/// @file
/// Normal maps: pictures of the directions in which a rough wall's small faces look.
#pragma once

#include <algorithm>

#include "ch03_surfaces/frame.hpp"

namespace lt {

// [decode-normal]
/// The normal that a texel stores as (n + 1) / 2.
/// @param texel  0 to 1: red along +u (right), green along +v (down), blue out of the surface
/// @return unit, in the local frame; never behind the surface
[[nodiscard]] inline vec3 decode_normal(vec3 texel) {
  vec3 n = 2.0f * texel - 1.0f;
  n.z = std::max(n.z, 0.01f);  // no map should say otherwise; files do
  return normalize(n);         // a mean of unit vectors is shorter than 1
}
// [decode-normal]

// [keep-visible]
/// The normal nearest to `normal` that someone in direction `wo` can see: a bump may turn its back
/// on the viewer, but then the viewer would not see that side of it.
/// @param normal, geometric, wo  unit; dot(geometric, wo) > 0
[[nodiscard]] inline vec3 keep_visible(vec3 normal, vec3 geometric, vec3 wo) {
  const float least = std::min(0.01f, dot(geometric, wo));
  const float cosine = dot(normal, wo);
  if (cosine >= least) return normal;
  return normalize(normal + (least - cosine) * wo);
}
// [keep-visible]

// [bumped]
/// A frame whose normal follows a normal map's texel; its tangent stays as near to +u as it can.
[[nodiscard]] inline Frame bumped(const Frame& frame, vec3 texel, vec3 wo) {
  const vec3 normal = frame.to_world(decode_normal(texel));
  return frame_along(keep_visible(normal, frame.normal, wo), frame.tangent);
}
// [bumped]

}  // namespace lt
