/// @file
/// The first picture: evening over a lake. No drawing and no data: one function, asked once for
/// each point. Points are in picture heights from the middle of the picture, x right, y up.
#pragma once

#include <cmath>

#include "ch01_pixels/paint.hpp"

namespace lt {

inline constexpr float waterline = -0.20f;

// [sky]
/// Gold over the horizon, then violet, then blue; and the sun, four times as bright as a screen's
/// white, in its glow.
[[nodiscard]] inline Rgb sky(vec2 p) {
  const Rgb gold(0.95f, 0.36f, 0.12f);
  const Rgb violet(0.20f, 0.09f, 0.22f);
  const Rgb blue(0.010f, 0.030f, 0.11f);
  const float height = p.y - waterline;
  Rgb color = glm::mix(gold, violet, glm::smoothstep(0.08f, 0.36f, height));
  color = glm::mix(color, blue, glm::smoothstep(0.22f, 0.75f, height));

  const Rgb sunlight(1.0f, 0.52f, 0.16f);
  const float distance = glm::distance(p, vec2(0.17f, 0.06f));
  const float glow = 0.009f / (0.011f + distance * distance);
  return color + sunlight * (distance < 0.055f ? 4.0f : glow);
}
// [sky]

// [ridge]
/// Height of a row of hills; row 0 is the nearest. Three waves that never meet the same way twice.
[[nodiscard]] inline float ridge(float x, int row) {
  const float i = static_cast<float>(row);
  const float hills = std::sin((3.1f - 0.2f * i) * x + 2.3f * i + 0.4f) +
                      0.45f * std::sin(7.3f * x + 1.7f * i) +
                      0.20f * std::sin(17.9f * x + 4.1f * i);
  return waterline + 0.045f + 0.042f * i + 0.045f * hills;
}
// [ridge]

// [landscape]
/// Rows of hills before the sky. The air between adds light of its own: farther is hazier.
[[nodiscard]] inline Rgb landscape(vec2 p) {
  constexpr int rows = 5;
  for (int row = 0; row < rows; ++row) {
    const float depth = ridge(p.x, row) - p.y;
    if (depth < 0.0f) continue;
    const float far = static_cast<float>(row + 1) / rows;
    const Rgb hill(0.006f, 0.016f, 0.024f);
    const Rgb haze = glm::mix(Rgb(0.04f, 0.10f, 0.17f), Rgb(0.58f, 0.21f, 0.24f), far);
    const float valley_mist = 1.0f - std::exp(-6.0f * depth);
    return glm::mix(hill, haze, far * far * (0.72f + 0.28f * valley_mist));
  }
  return sky(p);
}
// [landscape]

// [evening]
/// The whole picture. Water is the same function asked at another place: the mirrored point, a
/// little shifted by ripples.
[[nodiscard]] inline Rgb evening(vec2 p) {
  const float depth = waterline - p.y;
  if (depth < 0.0f) return landscape(p);
  const float ripple = std::sin(9.0f / (depth + 0.04f) + 6.0f * p.x) *
                       std::sin(31.0f / (depth + 0.06f) + 3.0f * p.x);
  const vec2 mirrored(p.x + 0.03f * ripple * depth, waterline + depth * (1.0f + 0.35f * ripple));
  return Rgb(0.45f, 0.52f, 0.60f) * landscape(mirrored) + Rgb(0.001f, 0.004f, 0.010f);
}
// [evening]

// [evening-picture]
/// The function as a picture. Rows of pixels go down, the landscape's y goes up.
[[nodiscard]] inline Image evening_picture(int width, int height) {
  return paint(width, height, [=](vec2 film) {
    const vec2 from_middle = (film - 0.5f * vec2(width, height)) / static_cast<float>(height);
    return evening({from_middle.x, -from_middle.y});
  });
}
// [evening-picture]

}  // namespace lt
