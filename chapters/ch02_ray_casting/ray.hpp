/// @file
/// A ray: where light could come from.
#pragma once

#include "common/math.hpp"

namespace lt {

// [ray]
/// Points origin + t * direction, t > 0.
struct Ray {
  vec3 origin;     ///< metres
  vec3 direction;  ///< unit length, so that t is a distance in metres

  [[nodiscard]] vec3 at(float t) const { return origin + t * direction; }
};
// [ray]

}  // namespace lt
