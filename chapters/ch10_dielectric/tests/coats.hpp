// Coats to test, and the places where they are asked: nine directions, from straight above to
// nearly along the surface, at five widths.
#pragma once

#include <array>
#include <cmath>
#include <stdexcept>

#include "ch05_rendering_equation/uniform_hemisphere.hpp"
#include "ch08_microfacets/albedo.hpp"
#include "ch08_microfacets/tests/oracles.hpp"
#include "ch10_dielectric/total_albedo.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

namespace lt::testing {

inline constexpr float glass_index = 1.5f;

/// The integral of 2 F mu over mu for index n, from outside, in closed form (Walsh 1926); for 1.5
/// it is 0.0917780.
inline double mean_fresnel(double n) {
  const double n2 = n * n, n4 = n2 * n2;
  return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
         n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
         2 * n * n2 * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
         8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
}

/// A direction at this angle, in no special azimuth.
inline vec3 slanting(float degrees) {
  const vec3 w = at_degrees(degrees);
  return {0.8f * w.x, -0.6f * w.x, w.z};
}

/// Calls f(alpha, wo) at all 45 places.
template <class F>
void over_grid(const F& f) {
  for (const float alpha : five_alphas)
    for (const float degrees : nine_angles)
      f(alpha, slanting(degrees));
}

inline ThesisBase thesis_base(Rgb albedo) {
  return {albedo, {glass_index}};
}
inline ReciprocalBase reciprocal_base(Rgb albedo) {
  return {albedo, {glass_index}};
}
inline ConservingBase conserving_base(Rgb albedo, const SpecularAlbedo& table) {
  return {albedo, 1.0f, table};
}

template <CoatedBase Base>
CoatedDiffuse<Base> coated(float alpha, const Base& base) {
  return {{{alpha}, {glass_index}}, base};
}

/// A table for each of the five widths, made once.
inline const SpecularAlbedo& table_of(float alpha) {
  static const std::array<SpecularAlbedo, 5> tables = [] {
    const auto& a = five_alphas;
    const auto of = [](float width) { return SpecularAlbedo(width, glass_index); };
    return std::array<SpecularAlbedo, 5>{of(a[0]), of(a[1]), of(a[2]), of(a[3]), of(a[4])};
  }();
  for (std::size_t i = 0; i < 5; ++i)
    if (five_alphas[i] == alpha) return tables[i];
  throw std::logic_error("no table of this alpha");
}

/// Calls f(coated BSDF) with each of the three bases.
template <class F>
void with_each_base(float alpha, Rgb albedo, const F& f) {
  f(coated(alpha, thesis_base(albedo)));
  f(coated(alpha, reciprocal_base(albedo)));
  f(coated(alpha, conserving_base(albedo, table_of(alpha))));
}

}  // namespace lt::testing
