/// @file
/// A lamp on the viewer's forehead: enough to see surfaces by. Not physics yet.
#pragma once

#include <algorithm>
#include <optional>

#include "ch03_surfaces/surface.hpp"

namespace lt {

/// How bright the headlight is.
struct Headlight {
  float brightness = 1.0f;  ///< of a white wall close by, seen straight on
  float reach = infinity;   ///< at this distance half of it is left, metres
};

// [headlight]
/// The brightness of a surface whose only lamp sits where the ray starts. There are no shadows to
/// ask for: what the lamp does not reach, the viewer does not see.
/// @param t  distance from lamp and viewer, metres
[[nodiscard]] inline Rgb lit(const Headlight& lamp, const Surface& surface, const Ray& ray,
                             float t) {
  if (is_emissive(surface.material)) return Rgb(1.0f);  // far brighter than the lamp: white
  const float cosine = std::max(0.0f, dot(surface.frame.normal, -ray.direction));
  const float near = t / lamp.reach;
  return lamp.brightness / (1.0f + near * near) * cosine * surface.material.tint;
}
// [headlight]

}  // namespace lt
