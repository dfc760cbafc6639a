/// @file
/// Directions to look at: as dots on a hemisphere, and counted in bins.
#pragma once

#include <algorithm>
#include <cmath>

#include "ch01_pixels/image.hpp"
#include "ch06_importance_sampling/diverging_color.hpp"
#include "ch06_importance_sampling/samplers.hpp"

namespace lt {

/// Adds a soft round dot, about 1.5 pixels across.
inline void add_dot(Image& image, vec2 at, Rgb color) {
  const ivec2 corner(glm::floor(at - 1.5f));
  for (int y = corner.y; y < corner.y + 4; ++y)
    for (int x = corner.x; x < corner.x + 4; ++x) {
      if (x < 0 || y < 0 || x >= image.width() || y >= image.height()) continue;
      const float distance = length(vec2(x, y) + 0.5f - at);
      image.at(x, y) += std::max(0.0f, 1.0f - distance / 1.5f) * color;
    }
}

// [dome]
/// A sampler's directions as dots on the hemisphere, and straight below them their places on the
/// disk: the shadows that they cast at noon.
/// @param left, width  the part of the picture to draw in, pixels
inline void draw_dome(Image& image, int left, int width, const NamedSampler& sampler, int count,
                      Pcg32& random) {
  const float tilt = 0.42f;  // of the disk's depth, seen from above the horizon
  const float radius = std::min(0.46f * static_cast<float>(width),
                                static_cast<float>(image.height()) / (2.2f + 2.0f * tilt));
  const float middle = static_cast<float>(left) + 0.5f * static_cast<float>(width);
  const float floor = static_cast<float>(image.height()) - radius * (tilt + 0.08f);
  const float dome = floor - radius * (2.0f * tilt + 0.06f);
  for (int i = 0; i < count; ++i) {
    const vec3 w = sampler.sample(random.next_vec2());
    const float shift = -tilt * w.y;
    const float lit = 0.55f - 0.45f * w.y;  // darker on the far side
    add_dot(image, {middle + radius * w.x, dome + radius * (shift - 0.9f * w.z)},
            lit * Rgb(0.35f, 0.62f, 1.0f));
    add_dot(image, {middle + radius * w.x, floor + radius * shift}, Rgb(0.75f, 0.36f, 0.10f));
  }
}
// [dome]

/// The uniform sampler on the left, on the right the cosine's or the one that `wrong` names.
[[nodiscard]] inline Image directions_picture(int width, int height, const std::string& wrong,
                                              int count, std::uint64_t seed) {
  Image image(width, height, Rgb(0.004f));
  const std::string left = wrong == "none" ? "uniform" : "cosine";
  Pcg32 random(seed);
  draw_dome(image, 0, width / 2, sampler_named(left, "none"), count, random);
  draw_dome(image, width / 2, width - width / 2, sampler_named("cosine", wrong), count, random);
  return image;
}

// [pull]
/// How far a bin's count lies from what is expected, in its own standard deviations; 0 where
/// nothing is expected and nothing is.
[[nodiscard]] inline double pull(double observed, double expected) {
  if (observed == expected) return 0;
  return expected > 0 ? (observed - expected) / std::sqrt(expected) : infinity;
}

/// Grey where a count is as expected, orange where there are too many, blue where too few; full
/// colour at 5 standard deviations.
[[nodiscard]] inline Rgb pull_color(double pull) {
  return diverging_color(pull / 5);
}
// [pull]

/// The bins of the upper hemisphere, unrolled: the azimuth to the right, z = 1 at the top.
[[nodiscard]] inline Image bins_picture(int width, int height, const DirectionBins& bins,
                                        const SamplerReport& report) {
  Image image(width, height);
  const int rows = bins.rows() / 2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int row = bins.rows() - 1 - y * rows / height;
      const auto bin = static_cast<std::size_t>(row * bins.columns() + x * bins.columns() / width);
      image.at(x, y) = pull_color(pull(report.observed[bin], report.expected[bin]));
    }
  return image;
}

}  // namespace lt
