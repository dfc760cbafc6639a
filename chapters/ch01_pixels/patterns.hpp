/// @file
/// Pictures that put a question to screen and eye.
#pragma once

#include <algorithm>
#include <cmath>

#include "ch01_pixels/paint.hpp"

namespace lt {

/// Side of the squares that the eye is meant to blend, in pixels.
inline constexpr int cell_side = 2;

/// Column and row of the cell around a point of the picture.
[[nodiscard]] inline ivec2 cell_of(vec2 film) {
  return ivec2(film) / cell_side;
}

// [checker]
/// Black and white squares: half the light of white. Two plain patches lie on them. The left one
/// sends half the light of white, the right one has half the code.
[[nodiscard]] inline Image checker(int width, int height) {
  const float side = 0.25f * static_cast<float>(std::min(width, 2 * height));
  return paint(width, height, [=](vec2 film) {
    const vec2 size(width, height);
    const auto is_in_patch = [&](vec2 middle) {
      const vec2 off = glm::abs(film - middle * size);
      return std::max(off.x, off.y) < 0.5f * side;
    };
    if (is_in_patch({0.25f, 0.5f})) return Rgb(0.5f);
    if (is_in_patch({0.75f, 0.5f})) return Rgb(from_code(128));
    const ivec2 cell = cell_of(film);
    return Rgb((cell.x + cell.y) % 2 == 0 ? 0.0f : 1.0f);
  });
}
// [checker]

// [gradient]
/// From one colour to another in three rows: codes mixed, squares of the two colours in the same
/// shares, light mixed.
[[nodiscard]] inline Image gradient(int width, int height) {
  const Rgb pink(0.85f, 0.03f, 0.20f);
  const Rgb green(0.03f, 0.55f, 0.20f);
  return paint(width, height, [=](vec2 film) {
    const float share = film.x / static_cast<float>(width);
    const int row = static_cast<int>(3.0f * film.y / static_cast<float>(height));
    if (row == 2) return glm::mix(pink, green, share);
    if (row == 1) {
      // Multiples of these two numbers, whole parts dropped, fall evenly between 0 and 1.
      const vec2 cell(cell_of(film));
      return glm::fract(0.754878f * cell.x + 0.569840f * cell.y) < share ? green : pink;
    }
    Rgb mixed;
    for (int c = 0; c < 3; ++c)
      mixed[c] = decode_srgb(glm::mix(encode_srgb(pink[c]), encode_srgb(green[c]), share));
    return mixed;
  });
}
// [gradient]

// [glow]
/// A dim golden glow: 6 percent of white at its brightest.
[[nodiscard]] inline Image glow(int width, int height) {
  return paint(width, height, [=](vec2 film) {
    const vec2 p = (film - 0.5f * vec2(width, height)) / static_cast<float>(height);
    return 0.06f * Rgb(1.0f, 0.62f, 0.30f) * std::exp(-5.0f * glm::dot(p, p));
  });
}
// [glow]

// [ramp]
/// Patches of light in stops: each sends twice as much as the one before, from 1/256 to 16. Rows:
/// grey, gold, and the same gold with a sixteenth of the light. A frame marks the light of
/// white, 1.
[[nodiscard]] inline Image ramp(int width, int height) {
  constexpr int first = -8;
  constexpr vec2 counts(13, 3);
  return paint(width, height, [=](vec2 film) {
    const vec2 patches = film * counts / vec2(width, height);
    const vec2 off = glm::abs(glm::fract(patches) - 0.5f);
    const int row = static_cast<int>(patches.y);
    const int stop = first + static_cast<int>(patches.x) - (row == 2 ? 4 : 0);
    if (std::max(off.x, off.y) > 0.44f) return Rgb(stop == 0 ? 0.4f : 0.0f);
    const Rgb hue = row == 0 ? Rgb(1.0f) : Rgb(1.0f, 0.62f, 0.16f);
    return std::exp2(static_cast<float>(stop)) * hue;
  });
}
// [ramp]

}  // namespace lt
