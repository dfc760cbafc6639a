/// @file
/// Linear light, the sRGB curve, and 8-bit codes.
#pragma once

#include <cmath>
#include <cstdint>

#include "common/math.hpp"

namespace lt {

/// Red, green and blue radiance, linear: twice the number is twice the light. Unit: W / (m^2 sr),
/// up to one factor for the whole picture. 1 is the brightest that a screen shows.
using Rgb = vec3;

// [encode]
/// Linear value to sRGB signal (IEC 61966-2-1).
/// @param linear  0 to 1
/// @return 0 to 1
[[nodiscard]] inline float encode_srgb(float linear) {
  if (linear <= 0.0031308f) return 12.92f * linear;
  return 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}
// [encode]

// [decode]
/// sRGB signal to linear value, the inverse of encode_srgb().
/// @param signal  0 to 1
/// @return 0 to 1
[[nodiscard]] inline float decode_srgb(float signal) {
  if (signal <= 0.04045f) return signal / 12.92f;
  return std::pow((signal + 0.055f) / 1.055f, 2.4f);
}
// [decode]

// [to-code]
/// Linear value to the nearest 8-bit sRGB code. Too bright becomes 255, negative and NaN become 0.
[[nodiscard]] inline std::uint8_t to_code(float linear) {
  if (!(linear > 0.0f)) return 0;  // also catches NaN
  if (linear >= 1.0f) return 255;
  return static_cast<std::uint8_t>(std::lround(255.0f * encode_srgb(linear)));
}
// [to-code]

/// 8-bit sRGB code to linear value, 0 to 1.
[[nodiscard]] inline float from_code(std::uint8_t code) {
  return decode_srgb(static_cast<float>(code) / 255.0f);
}

}  // namespace lt
