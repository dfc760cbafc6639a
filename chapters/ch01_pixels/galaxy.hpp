/// @file
/// A picture made of single bright pixels: the hardest test for whoever makes pictures smaller.
#pragma once

#include <cmath>
#include <random>

#include "ch01_pixels/image.hpp"

namespace lt {

/// One star: where it is in picture heights from the middle of the galaxy, and its light.
struct Star {
  vec2 place;
  Rgb light;
};

/// A star in one of two spiral arms: old and golden near the middle, young and blue outside.
/// @param random  returns a number from 0 to 1, another one at each call
template <class Random>
[[nodiscard]] Star random_star(const Random& random) {
  const float share = random();
  const float radius = 0.75f * share * share;
  float off_arm = -2.0f;  // four draws: mostly near the arm, seldom far
  for (int i = 0; i < 4; ++i)
    off_arm += random();
  const float arm = random() < 0.5f ? 0.0f : pi;
  const float angle = arm + 2.6f * std::log(radius + 0.02f) + 0.75f * off_arm;
  // A flat disk seen from the side, and turned a little.
  const vec2 disk = radius * vec2(std::cos(angle), 0.5f * std::sin(angle));
  const vec2 place(0.92f * disk.x + 0.39f * disk.y, 0.92f * disk.y - 0.39f * disk.x);
  const Rgb gold(1.0f, 0.55f, 0.22f);
  const Rgb blue(0.35f, 0.60f, 1.0f);
  const float brightness = 0.45f / (0.15f + random());
  return {place, brightness * glm::mix(gold, blue, glm::smoothstep(0.02f, 0.30f, radius))};
}

// [galaxy]
/// Stars before black, each in one pixel; one for each 48 pixels of the picture.
[[nodiscard]] inline Image galaxy(int width, int height) {
  std::mt19937 bits(1);  // the same numbers on every machine
  const auto random = [&bits] { return static_cast<float>(bits() >> 8) * 0x1p-24f; };
  Image image(width, height);
  for (int count = width * height / 48; count > 0; --count) {
    const Star star = random_star(random);
    const vec2 film = 0.5f * vec2(width, height) + static_cast<float>(height) * star.place;
    const ivec2 pixel(glm::floor(film));
    if (pixel.x < 0 || pixel.x >= width || pixel.y < 0 || pixel.y >= height) continue;
    image.at(pixel.x, pixel.y) += star.light;  // light adds
  }
  return image;
}
// [galaxy]

}  // namespace lt
