/// @file
/// Pi, by throwing darts at a square and counting those that hit the disk in it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ch01_pixels/image.hpp"
#include "ch04_monte_carlo/pcg32.hpp"
#include "common/testkit/statistics.hpp"

namespace lt {

// [darts]
/// Points of the square [-1, 1] x [-1, 1], all equally likely.
[[nodiscard]] inline std::vector<vec2> throw_darts(int count, Pcg32& random) {
  std::vector<vec2> darts;
  for (int i = 0; i < count; ++i)
    darts.push_back(2.0f * random.next_vec2() - 1.0f);
  return darts;
}

[[nodiscard]] inline bool hits_disk(vec2 dart) {
  return dot(dart, dart) < 1.0f;
}

/// Each dart says 4 (the square's area) or 0; their mean estimates the disk's area.
[[nodiscard]] inline RunningMean estimate_pi(const std::vector<vec2>& darts) {
  RunningMean samples;
  for (const vec2 dart : darts)
    samples.add(hits_disk(dart) ? 4 : 0);
  return samples;
}
// [darts]

// [stratified-darts]
/// One point in each of side x side equal cells of the square.
[[nodiscard]] inline std::vector<vec2> throw_stratified_darts(int side, Pcg32& random) {
  std::vector<vec2> darts;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const vec2 within = random.next_vec2();
      darts.push_back(2.0f * (vec2(column, row) + within) / static_cast<float>(side) - 1.0f);
    }
  return darts;
}
// [stratified-darts]

/// The darts as a picture, y up: gold inside the disk, blue outside.
[[nodiscard]] inline Image dart_picture(const std::vector<vec2>& darts, int width, int height) {
  const auto side = static_cast<float>(std::min(width, height));
  const float radius = 0.004f * side + 0.6f;  // pixels
  Image image(width, height, Rgb(0.010f, 0.014f, 0.022f));
  for (const vec2 dart : darts) {
    const vec2 middle = 0.5f * (vec2(width, height) + 0.97f * side * vec2(dart.x, -dart.y));
    const Rgb color = hits_disk(dart) ? Rgb(0.95f, 0.50f, 0.10f) : Rgb(0.05f, 0.22f, 0.60f);
    const ivec2 low = glm::max(ivec2(glm::floor(middle - radius)), ivec2(0));
    const ivec2 high = glm::min(ivec2(glm::ceil(middle + radius)), ivec2(width, height));
    for (int y = low.y; y < high.y; ++y)
      for (int x = low.x; x < high.x; ++x) {
        const float inside = radius + 0.5f - distance(middle, vec2(x, y) + 0.5f);
        image.at(x, y) = glm::mix(image.at(x, y), color, glm::clamp(inside, 0.0f, 1.0f));
      }
  }
  return image;
}

}  // namespace lt
