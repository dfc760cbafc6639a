/// @file
/// Where samples are summed up.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ch01_pixels/image.hpp"

namespace lt {

// [film-pixel]
/// Sums and counts of a pixel's samples, in double: a thousand small numbers added to a large one
/// must not be lost.
struct FilmPixel {
  glm::dvec3 sum{0.0};
  std::int64_t count = 0;
  std::int64_t bad = 0;  ///< samples that were negative, infinite or NaN: counted, not repaired
};
// [film-pixel]

/// A picture that is being estimated.
class Film {
 public:
  /// @param width, height  pixels, >= 1
  Film(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] FilmPixel& at(int x, int y) { return pixels_[index(x, y)]; }
  [[nodiscard]] const FilmPixel& at(int x, int y) const { return pixels_[index(x, y)]; }

  // [film-add]
  /// Takes one more sample of pixel (x, y) into account, W/(m^2 sr), whatever it is.
  void add(int x, int y, Rgb sample) {
    FilmPixel& pixel = at(x, y);
    pixel.sum += glm::dvec3(sample);
    ++pixel.count;
    const float least = std::min({sample.r, sample.g, sample.b});
    const float total = sample.r + sample.g + sample.b;
    if (!(least >= 0.0f && std::isfinite(total))) ++pixel.bad;
  }
  // [film-add]

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * width_ + x;
  }

  int width_;
  int height_;
  std::vector<FilmPixel> pixels_;
};

// [developed]
/// The mean of every pixel's samples; black where there is none.
[[nodiscard]] inline Image developed(const Film& film) {
  Image image(film.width(), film.height());
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      const FilmPixel& pixel = film.at(x, y);
      if (pixel.count > 0) image.at(x, y) = Rgb(pixel.sum / static_cast<double>(pixel.count));
    }
  return image;
}
// [developed]

// [film-summary]
/// What a film's counts say.
struct FilmSummary {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();  ///< samples in a pixel
  std::int64_t most = 0;                                          ///< samples in a pixel
  std::int64_t total = 0;                                         ///< samples in all pixels
  std::int64_t bad = 0;            ///< samples in all pixels that were negative, infinite or NaN
  std::optional<ivec2> first_bad;  ///< the first pixel, row by row, that has one
};

[[nodiscard]] inline FilmSummary summary(const Film& film) {
  FilmSummary found;
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      const FilmPixel& pixel = film.at(x, y);
      found.least = std::min(found.least, pixel.count);
      found.most = std::max(found.most, pixel.count);
      found.total += pixel.count;
      found.bad += pixel.bad;
      if (pixel.bad > 0 && !found.first_bad) found.first_bad = ivec2(x, y);
    }
  return found;
}

/// @throws std::runtime_error  a sample was negative, infinite or NaN; names the first such pixel
inline void require_good_samples(const Film& film) {
  const FilmSummary found = summary(film);
  if (!found.first_bad) return;
  const ivec2 p = *found.first_bad;
  const FilmPixel& pixel = film.at(p.x, p.y);
  throw std::runtime_error(
      std::to_string(found.bad) + " samples are negative, infinite or NaN; first in pixel (" +
      std::to_string(p.x) + ", " + std::to_string(p.y) + "): " + std::to_string(pixel.bad) +
      " of its " + std::to_string(pixel.count));
}
// [film-summary]

}  // namespace lt
