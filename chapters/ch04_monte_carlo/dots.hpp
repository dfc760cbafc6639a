/// @file
/// A picture as a density: dots that fall where it is bright.
#pragma once

#include <vector>

#include "ch01_pixels/evening.hpp"
#include "ch04_monte_carlo/pcg32.hpp"
#include "ch04_monte_carlo/tabulated.hpp"

namespace lt {

// [luminance]
/// How bright a color looks: the eye sees green best (ITU-R BT.709).
[[nodiscard]] inline double luminance(Rgb color) {
  return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}
// [luminance]

// [picture-density]
/// The density over [0, 1) x [0, 1), y down, that is as high as the picture is bright.
/// @param picture  not all black
[[nodiscard]] inline TabulatedDensity2D picture_density(const Image& picture) {
  std::vector<double> weights;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      weights.push_back(luminance(picture.at(x, y)));
  return {weights, picture.width()};
}
// [picture-density]

// [dots]
/// The evening in `count` dots of the same light.
[[nodiscard]] inline Image dot_picture(int width, int height, int count, Pcg32& random) {
  const TabulatedDensity2D density = picture_density(evening_picture(width, height));
  Image image(width, height);
  for (int i = 0; i < count; ++i) {
    const glm::dvec2 p = density.sample(random.next_vec2());
    const ivec2 pixel(p * glm::dvec2(width, height));
    image.at(pixel.x, pixel.y) += Rgb(0.80f, 0.42f, 0.14f);
  }
  return image;
}
// [dots]

}  // namespace lt
