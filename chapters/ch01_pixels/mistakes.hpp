/// @file
/// Wrong on purpose: what a screen shows when a program takes light for codes, or codes for light.
/// Each takes the right picture and returns the light of the wrong one.
#pragma once

#include <algorithm>
#include <cmath>

#include "ch01_pixels/halve.hpp"
#include "ch01_pixels/paint.hpp"

namespace lt {

// [as-codes]
/// Linear values go into the file as if they were codes: value * 255, not encoded. The screen
/// decodes what it was given.
[[nodiscard]] inline Image stored_without_encoding(const Image& image) {
  return changed(image, [](float linear) { return decode_srgb(std::clamp(linear, 0.0f, 1.0f)); });
}
// [as-codes]

// [linear-codes]
/// 256 codes at equal steps of light, on a screen that knows it and does not decode.
[[nodiscard]] inline Image in_linear_codes(const Image& image) {
  return changed(image, [](float linear) {
    return std::round(255.0f * std::clamp(linear, 0.0f, 1.0f)) / 255.0f;
  });
}
// [linear-codes]

// [halve-codes]
/// Half the size, by averaging codes.
[[nodiscard]] inline Image halve_codes(const Image& image) {
  const auto encode = [](float linear) { return encode_srgb(std::clamp(linear, 0.0f, 1.0f)); };
  return changed(halve(changed(image, encode)), decode_srgb);
}
// [halve-codes]

}  // namespace lt
