/// @file
/// Relief: from a pattern, which says how high and of what colour each point is, to the two
/// pictures that make a wall of it.
#pragma once

#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

#include "ch01_pixels/image.hpp"
#include "ch03_surfaces/texture.hpp"
#include "ch03_surfaces/texture_maps.hpp"

namespace lt {

// [height-field]
/// size x size heights on the unit square, repeated without end to all sides.
/// Unit of height: the side of the square. On a 3 m wall, 0.001 is 3 mm.
class HeightField {
 public:
  explicit HeightField(int size) : size_(size), heights_(static_cast<std::size_t>(size) * size) {
    assert(size >= 1);
  }

  [[nodiscard]] int size() const { return size_; }
  /// x to the right, y down; beyond each edge comes the opposite one.
  [[nodiscard]] float& at(int x, int y) { return heights_[index(x, y)]; }
  [[nodiscard]] float at(int x, int y) const { return heights_[index(x, y)]; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(wrap(y, size_)) * size_ + wrap(x, size_);
  }

  int size_;
  std::vector<float> heights_;
};
// [height-field]

// [normal-at]
/// The unit normal of the relief at one of its points: x along u (right), y along v (down),
/// z outward, > 0. The surface z = h(u, v) has the normal (-dh/du, -dh/dv, 1), made unit; slopes
/// are differences of the two neighbours' heights over their distance, 2 / size.
[[nodiscard]] inline vec3 normal_at(const HeightField& heights, int x, int y) {
  const float per_side = static_cast<float>(heights.size()) / 2.0f;
  const float slope_u = (heights.at(x + 1, y) - heights.at(x - 1, y)) * per_side;
  const float slope_v = (heights.at(x, y + 1) - heights.at(x, y - 1)) * per_side;
  return normalize(vec3(-slope_u, -slope_v, 1.0f));
}
// [normal-at]

// [normals-of]
/// The normal map of a relief: each normal's -1..1 stored as 0..1, so that flat is (0.5, 0.5, 1).
[[nodiscard]] inline Image normals_of(const HeightField& heights) {
  Image normals(heights.size(), heights.size());
  for (int y = 0; y < heights.size(); ++y)
    for (int x = 0; x < heights.size(); ++x)
      normals.at(x, y) = (normal_at(heights, x, y) + 1.0f) / 2.0f;
  return normals;
}
// [normals-of]

// [round-box]
/// Distance from `p` to the outline of a rectangle with round corners around (0, 0).
/// @param half    half the rectangle's sides
/// @param radius  of the corners, at most the smaller of `half`
/// @return negative inside, positive outside
[[nodiscard]] inline float round_box(vec2 p, vec2 half, float radius) {
  const vec2 beyond = glm::abs(p) - (half - radius);  // the corner's centre
  const float outside = glm::length(glm::max(beyond, vec2(0.0f)));
  const float inside = glm::min(glm::max(beyond.x, beyond.y), 0.0f);
  return outside + inside - radius;
}
// [round-box]

// [paint]
/// What a pattern says about one point.
struct PatternPoint {
  Rgb color;     ///< linear reflectance, 0 to 1
  float height;  ///< in sides of the square, see HeightField
};

/// Asks the pattern at the middle of each texel.
/// @param pattern  PatternPoint(vec2 uv); repeats with period 1 in u (right) and v (down)
/// @param size     of the pictures, texels, >= 1
template <class Pattern>
[[nodiscard]] TextureMaps paint(const Pattern& pattern, int size) {
  Image color(size, size);
  HeightField heights(size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const vec2 uv = (vec2(x, y) + 0.5f) / static_cast<float>(size);
      const PatternPoint point = pattern(uv);
      color.at(x, y) = glm::clamp(point.color, 0.0f, 1.0f);
      heights.at(x, y) = point.height;
    }
  return {std::move(color), normals_of(heights)};
}
// [paint]

}  // namespace lt
