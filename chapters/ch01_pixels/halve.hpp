/// @file
/// Smaller pictures: averages of light.
#pragma once

#include <algorithm>

#include "ch01_pixels/image.hpp"

namespace lt {

// [halve]
/// The picture at half the size: each pixel is the mean of the 2 x 2 pixels that it covers. Linear
/// light in, linear light out; nothing is clamped. The last row or column of an odd side counts
/// twice, so that a side of n pixels becomes (n + 1) / 2.
[[nodiscard]] inline Image halve(const Image& image) {
  Image half((image.width() + 1) / 2, (image.height() + 1) / 2);
  for (int y = 0; y < half.height(); ++y) {
    for (int x = 0; x < half.width(); ++x) {
      const int left = 2 * x, right = std::min(left + 1, image.width() - 1);
      const int upper = 2 * y, lower = std::min(upper + 1, image.height() - 1);
      half.at(x, y) = 0.25f * (image.at(left, upper) + image.at(right, upper) +
                               image.at(left, lower) + image.at(right, lower));
    }
  }
  return half;
}
// [halve]

}  // namespace lt
