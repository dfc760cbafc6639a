/// @file
/// Looking a texture up between its texels.
#pragma once

#include <cassert>
#include <cmath>

#include "ch01_pixels/image.hpp"

namespace lt {

// [wrap]
/// Texel `i` of a row of n that repeats without end: -1 is the last one, n is the first one.
[[nodiscard]] constexpr int wrap(int i, int n) {
  const int rest = i % n;  // -n < rest < n: C++ rounds towards 0, so rest has the sign of i
  return rest < 0 ? rest + n : rest;
}

/// The same for a neighbour, -n <= i < 2 n: comparisons are cheaper than the division in %.
[[nodiscard]] constexpr int wrap_near(int i, int n) {
  assert(-n <= i && i < 2 * n);
  return i < 0 ? i + n : (i < n ? i : i - n);
}
// [wrap]

// [nearest]
/// The texel in whose square `uv` lies.
[[nodiscard]] inline Rgb nearest(const Image& texture, vec2 uv) {
  const vec2 p = glm::floor((uv - glm::floor(uv)) * vec2(texture.width(), texture.height()));
  return texture.at(wrap_near(static_cast<int>(p.x), texture.width()),
                    wrap_near(static_cast<int>(p.y), texture.height()));
}
// [nearest]

// [bilinear]
/// The mean of the four texels around `uv`, each weighted by its nearness.
/// @param uv  finite; texel (i, j) itself is at ((i + 0.5) / width, (j + 0.5) / height)
[[nodiscard]] inline Rgb bilinear(const Image& texture, vec2 uv) {
  assert(std::isfinite(uv.x) && std::isfinite(uv.y));
  // In texels, counted from the middle of the first one.
  const vec2 p = (uv - glm::floor(uv)) * vec2(texture.width(), texture.height()) - 0.5f;
  const vec2 corner = glm::floor(p);
  const vec2 f = p - corner;

  const int x0 = wrap_near(static_cast<int>(corner.x), texture.width());
  const int y0 = wrap_near(static_cast<int>(corner.y), texture.height());
  const int x1 = wrap_near(x0 + 1, texture.width());
  const int y1 = wrap_near(y0 + 1, texture.height());
  const Rgb upper = glm::mix(texture.at(x0, y0), texture.at(x1, y0), f.x);
  const Rgb lower = glm::mix(texture.at(x0, y1), texture.at(x1, y1), f.x);
  return glm::mix(upper, lower, f.y);
}
// [bilinear]

}  // namespace lt
