/// @file
/// A picture in memory: linear radiance, one Rgb per pixel.
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

#include "ch01_pixels/color.hpp"

namespace lt {

// [image]
/// width x height pixels. x goes right from 0, y goes *down* from 0: (0, 0) is the top left.
class Image {
 public:
  Image() = default;
  /// @param width, height  pixels, >= 1
  Image(int width, int height, Rgb fill = Rgb(0.0f))
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height, fill) {
    assert(width >= 1 && height >= 1);
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] Rgb& at(int x, int y) { return pixels_[index(x, y)]; }
  [[nodiscard]] const Rgb& at(int x, int y) const { return pixels_[index(x, y)]; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    assert(x >= 0 && x < width_ && y >= 0 && y < height_);
    return static_cast<std::size_t>(y) * width_ + x;
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Rgb> pixels_;
};
// [image]

}  // namespace lt
