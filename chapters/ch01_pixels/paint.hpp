/// @file
/// From a function to a picture, and from one picture to another, number by number.
#pragma once

#include "ch01_pixels/image.hpp"

namespace lt {

// [paint]
/// The picture of a function: each pixel holds the function's value at the pixel's middle.
/// @param light_at  called with a point in pixels from the top left corner, returns an Rgb
template <class Function>
[[nodiscard]] Image paint(int width, int height, const Function& light_at) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) = light_at(vec2(x, y) + 0.5f);
  return image;
}
// [paint]

/// The picture with `change` applied to each of its numbers, three per pixel.
/// @param change  called with a float, returns a float
template <class Function>
[[nodiscard]] Image changed(Image image, const Function& change) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = change(image.at(x, y)[c]);
  return image;
}

}  // namespace lt
