/// @file
/// Which facets can mirror one direction into another.
#pragma once

#include <cmath>
#include <limits>

#include "common/math.hpp"

namespace lt {

// [half-vector]
/// The normal of the facets that mirror `wo` into `wi`: half-way between them.
/// @param wo, wi  unit, away from the surface
/// @return unit; the null vector where the two point in opposite directions: no facet does it, and
///         none faces a null vector, so that D of it is 0
[[nodiscard]] inline vec3 half_vector(vec3 wo, vec3 wi) {
  const vec3 sum = wo + wi;
  const float squared_length = dot(sum, sum);
  if (squared_length < std::numeric_limits<float>::min()) return vec3(0.0f);
  return sum / std::sqrt(squared_length);
}
// [half-vector]

}  // namespace lt
