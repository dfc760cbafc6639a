/// @file
/// From the number on a material to the width of its reflections.
#pragma once

#include <algorithm>

namespace lt {

// [alpha]
/// The smallest width that is told from none. Nine tenths of such a surface lean by less than a
/// fifth of a degree: to the eye it is a mirror. Ggx itself holds down to 1e-4; but a half vector,
/// made of two rounded directions, is off by some 1e-7, which is a ten-thousandth of this width and
/// a larger part of any smaller one. There the honest model is the delta of chapter 7.
inline constexpr float smallest_alpha = 1e-3f;

/// The thesis' alpha: the roughness itself. Alpha is the tangent of an angle: half of the surface,
/// seen from straight above, leans by less than atan(alpha); 45 degrees for alpha 1.
/// @param roughness  0 polished to 1 rough
/// @return smallest_alpha to 1
[[nodiscard]] inline float alpha_of(float roughness) {
  return std::max(roughness, smallest_alpha);
}
// [alpha]

// [alpha-of-square]
/// The alpha of most other renderers: the square of the roughness, because equal steps of the
/// slider then look about equal (Burley 2012). Their roughness 0.5 is the thesis' 0.25.
/// @param roughness  0 polished to 1 rough
/// @return smallest_alpha to 1
[[nodiscard]] inline float alpha_of_square(float roughness) {
  return std::max(roughness * roughness, smallest_alpha);
}
// [alpha-of-square]

}  // namespace lt
