/// @file
/// Exercise 03.1: what you write and what the checker calls.
#pragma once

#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// A grey picture: one value for each texel, row by row from the top.
struct Texture {
  int width;
  int height;
  std::vector<double> values;

  /// The texel in column x and row y, both from 0.
  [[nodiscard]] double at(int x, int y) const {
    if (x < 0 || x >= width || y < 0 || y >= height)
      throw std::out_of_range("no texel (" + std::to_string(x) + ", " + std::to_string(y) + ")");
    return values[static_cast<std::size_t>(y) * width + x];
  }
};

/// Where on the picture a point of a sphere lies.
/// @param n  normal of the sphere at the point; as long as 1, give or take rounding
/// @return u right, v down, both 0 to 1; the middle of the picture faces -z, its top is the north
///         pole, y = 1
[[nodiscard]] glm::dvec2 sphere_uv(glm::dvec3 n);

/// The mean of the four texels around `uv`, weighted by nearness. The picture repeats.
/// @param uv  may lie far outside 0 to 1; the middle of texel (x, y) is at
///            ((x + 0.5) / width, (y + 0.5) / height)
[[nodiscard]] double bilinear(const Texture& texture, glm::dvec2 uv);

}  // namespace exercise
