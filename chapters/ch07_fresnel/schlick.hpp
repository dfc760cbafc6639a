/// @file
/// A famous short cut, to be compared with: no picture of the course uses it.
#pragma once

#include <concepts>

namespace lt {

// [schlick]
/// Schlick's approximation of Fresnel's equations (1994): right at the normal, right at the
/// horizon, and a fifth power in between.
/// @param cos_here   cosine of the angle to the normal, 0 to 1
/// @param at_normal  reflected share at cos 1
template <std::floating_point Real>
[[nodiscard]] Real schlick(Real cos_here, Real at_normal) {
  const Real m = 1 - cos_here;
  return at_normal + (1 - at_normal) * (m * m) * (m * m) * m;
}
// [schlick]

}  // namespace lt
