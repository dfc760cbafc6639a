/// @file
/// The colours of maps that show more and less.
#pragma once

#include <algorithm>
#include <cmath>

#include "ch01_pixels/image.hpp"

namespace lt {

/// From blue at -1 by way of grey at 0 to orange at 1; full colour beyond.
[[nodiscard]] inline Rgb diverging_color(double value) {
  const auto part = static_cast<float>(std::clamp(value, -1.0, 1.0));
  const Rgb full = part > 0 ? Rgb(1.0f, 0.38f, 0.03f) : Rgb(0.03f, 0.25f, 1.0f);
  return glm::mix(Rgb(0.18f), full, std::abs(part));
}

}  // namespace lt
