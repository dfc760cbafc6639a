/// @file
/// Exercise 01.2: what you write and what the checker calls.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// A grey picture. Pixel (x, y) is light[y * width + x]; row 0 is on top.
struct Picture {
  int width;                  ///< even, >= 2
  int height;                 ///< even, >= 2
  std::vector<double> light;  ///< linear: 0 is black, 1 is white, a lamp is more than 1
};

/// Given: the 8-bit sRGB code of a linear value, as in exercise 01.1. NaN becomes 0.
[[nodiscard]] inline int to_code(double linear) {
  if (!(linear > 0.0)) return 0;
  const double light = std::min(linear, 1.0);
  const double signal =
      light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
  return static_cast<int>(255.0 * signal + 0.5);
}

/// The codes of the picture at half its width and height. Each pixel shows the 2 x 2 pixels that
/// it covers as an eye sees them from far away.
/// @return width/2 * height/2 codes, row by row from the top
[[nodiscard]] std::vector<int> halved_codes(const Picture& picture);

}  // namespace exercise
