/// @file
/// Two angles at which reflection is out of the ordinary.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>

namespace lt {

// [brewster]
/// The angle to the normal at which light that swings in the plane of the rays is not reflected at
/// all: the reflected and the refracted ray would be perpendicular (Brewster 1815).
/// @return radians
template <std::floating_point Real>
[[nodiscard]] Real brewster_angle(Real n_here, Real n_beyond) {
  return std::atan(n_beyond / n_here);
}
// [brewster]

// [critical]
/// The angle to the normal from which on all light is reflected.
/// @return radians; nothing where n_here <= n_beyond: then some light always gets through
template <std::floating_point Real>
[[nodiscard]] std::optional<Real> critical_angle(Real n_here, Real n_beyond) {
  if (n_here <= n_beyond) return std::nullopt;
  return std::asin(n_beyond / n_here);
}
// [critical]

}  // namespace lt
