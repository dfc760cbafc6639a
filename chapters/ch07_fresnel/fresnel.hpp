/// @file
/// How much of the light a smooth surface reflects: Fresnel's equations.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "ch01_pixels/color.hpp"

namespace lt {

/// Index of refraction of air, and of empty space.
inline constexpr float index_of_air = 1.0f;

// [squared-cosine]
/// Squared cosine of the angle on the other side, by Snell's law sin(beyond) = eta sin(here).
/// Negative: no such angle, all light is reflected.
/// @param cos_here  cosine of the angle to the normal on this side, 0 to 1
/// @param eta       index here / index beyond, > 0
template <std::floating_point Real>
[[nodiscard]] Real squared_cos_beyond(Real cos_here, Real eta) {
  // 1 - eta^2 (1 - cos^2), in an order that keeps small cosines.
  return (1 - eta) * (1 + eta) + eta * eta * cos_here * cos_here;
}
// [squared-cosine]

// [polarised]
/// Reflected share of light that swings across the plane of both rays and the normal (s), and of
/// light that swings in it (p).
template <std::floating_point Real>
struct Reflectance {
  Real s;  ///< 0 to 1
  Real p;  ///< 0 to 1
};

/// Fresnel's equations for two clear media.
/// @param cos_here  cosine of the angle to the normal on the side from which one looks, 0 to 1
/// @param n_here    index of refraction on that side, > 0
/// @param n_beyond  index of refraction on the other side, > 0
template <std::floating_point Real>
[[nodiscard]] Reflectance<Real> reflectance_dielectric(Real cos_here, Real n_here, Real n_beyond) {
  if (n_here == n_beyond) return {0, 0};  // no surface; at cos 0 it would be 0 / 0
  const Real squared_cos = squared_cos_beyond(cos_here, n_here / n_beyond);
  if (!(squared_cos > 0)) return {1, 1};  // total internal reflection
  const Real cos_beyond = std::sqrt(squared_cos);
  const Real s =
      (n_here * cos_here - n_beyond * cos_beyond) / (n_here * cos_here + n_beyond * cos_beyond);
  const Real p =
      (n_beyond * cos_here - n_here * cos_beyond) / (n_beyond * cos_here + n_here * cos_beyond);
  return {s * s, p * p};
}
// [polarised]

// [dielectric]
/// Reflected share of light without a preferred direction of swing: the mean of both kinds. Equal
/// to thesis eq. 4 (Walter et al. 2007, eq. 22), with total internal reflection.
/// @param cos_here, n_here, n_beyond  as above
/// @return 0 to 1
template <std::floating_point Real>
[[nodiscard]] Real fresnel_dielectric(Real cos_here, Real n_here, Real n_beyond) {
  const Reflectance<Real> share = reflectance_dielectric(cos_here, n_here, n_beyond);
  return (share.s + share.p) / 2;
}
// [dielectric]

/// Of a complex number.
template <std::floating_point Real>
[[nodiscard]] Real squared_length(Real real_part, Real imaginary_part) {
  return real_part * real_part + imaginary_part * imaginary_part;
}

// [conductor]
/// The same for a metal, whose index is complex: eta + i k. Thesis eq. 9, corrected (Lagarde 2013).
/// @param cos_here  cosine of the angle to the normal, 0 to 1
/// @param n_here    index of refraction outside the metal, > 0
/// @param eta       real part of the metal's index, > 0
/// @param k         imaginary part, the extinction coefficient, >= 0; with 0 it is a dielectric
/// @return 0 to 1
template <std::floating_point Real>
[[nodiscard]] Real fresnel_conductor(Real cos_here, Real n_here, Real eta, Real k) {
  if (eta == n_here && k == 0) return 0;  // no surface
  const Real squared_eta = (eta / n_here) * (eta / n_here);
  const Real squared_k = (k / n_here) * (k / n_here);
  const Real squared_cos = cos_here * cos_here;
  const Real squared_sin = 1 - squared_cos;

  // a + i b = sqrt((eta + i k)^2 - sin^2): the index times the cosine beyond, both complex.
  const Real real_part = squared_eta - squared_k - squared_sin;
  const Real length = std::sqrt(real_part * real_part + 4 * squared_eta * squared_k);  // a^2 + b^2
  const Real a = std::sqrt(std::max(Real(0), (length + real_part) / 2));
  const Real b = std::sqrt(std::max(Real(0), (length - real_part) / 2));

  const Real s = squared_length(a - cos_here, b) / squared_length(a + cos_here, b);
  const Real p = s * squared_length(a * cos_here - squared_sin, b * cos_here) /
                 squared_length(a * cos_here + squared_sin, b * cos_here);
  return (s + p) / 2;
}
// [conductor]

// [conductor-rgb]
/// A metal in colour: each channel has an index of its own.
[[nodiscard]] inline Rgb fresnel_conductor(float cos_here, float n_here, Rgb eta, Rgb k) {
  return {fresnel_conductor(cos_here, n_here, eta.r, k.r),
          fresnel_conductor(cos_here, n_here, eta.g, k.g),
          fresnel_conductor(cos_here, n_here, eta.b, k.b)};
}
// [conductor-rgb]

}  // namespace lt
