/// @file
/// The pictures that the program offers, by name.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "ch05_rendering_equation/lit_room.hpp"
#include "ch05_rendering_equation/mistakes.hpp"
#include "ch05_rendering_equation/progressive.hpp"

namespace lt {

/// What to show.
struct LitViewOptions {
  std::string view = "room";   ///< room, or strip
  std::string camera = "far";  ///< far or near, for the room
  std::string wrong = "none";  ///< a mistake that the text shows
  int depth = 8;               ///< scattering events at most, >= 0
  int texels = 256;            ///< side of the walls' textures
};

// [any-estimator]
/// An estimator chosen at run time: one indirect call for each path, none inside it.
using AnyEstimator = std::function<Rgb(const Ray&, Pcg32&)>;

/// @param wrong  none, cosine, pi, offset or depth
/// @param scene  must outlive what is returned
[[nodiscard]] inline AnyEstimator estimator_for(const std::string& wrong,
                                                const TexturedScene& scene, int depth) {
  if (wrong == "cosine")
    return [&scene, depth](const Ray& ray, Pcg32& random) {
      return radiance_recursive(scene, mistakes::without_cosine_at, ray, depth, random);
    };
  if (wrong == "pi")
    return [&scene, depth](const Ray& ray, Pcg32& random) {
      return radiance_recursive(scene, mistakes::without_pi_at, ray, depth, random);
    };
  if (wrong == "offset")
    return [&scene, depth](const Ray& ray, Pcg32& random) {
      return radiance_recursive(mistakes::WithoutOffset<TexturedScene>{scene}, uniform_lambert_at,
                                ray, depth, random);
    };
  if (wrong == "depth")
    return [&scene, depth](const Ray& ray, Pcg32& random) {
      return mistakes::radiance_black_end(scene, uniform_lambert_at, ray, depth, random);
    };
  return [&scene, depth](const Ray& ray, Pcg32& random) {
    return radiance_recursive(scene, uniform_lambert_at, ray, depth, random);
  };
}
// [any-estimator]

/// Copies `part` into `image`, `left` pixels from the left.
inline void paste_at(Image& image, const Image& part, int left) {
  for (int y = 0; y < part.height(); ++y)
    for (int x = 0; x < part.width(); ++x)
      image.at(left + x, y) = part.at(x, y);
}

/// Panels of the strip: samples per pixel.
inline constexpr std::array<int, 6> strip_samples{1, 4, 16, 64, 256, 1024};
inline constexpr int strip_zoom = 4;  ///< pixels of the strip along a side of a pixel of a panel

/// Puts `panel` number `number` into the strip, enlarged, behind a white line.
inline void paste(Image& strip, const Image& panel, std::size_t number) {
  const auto left_of = [&](std::size_t i) {
    return strip.width() * static_cast<int>(i) / static_cast<int>(strip_samples.size());
  };
  const int left = left_of(number);
  for (int y = 0; y < strip.height(); ++y)
    for (int x = left; x < left_of(number + 1); ++x) {
      const bool is_line = number > 0 && x < left + 2;
      strip.at(x, y) = is_line ? Rgb(1.0f) : panel.at((x - left) / strip_zoom, y / strip_zoom);
    }
}

/// One window of the room after 1, 4, 16, ..., 1024 samples per pixel, side by side.
/// @param range  seed, threads and tiles
[[nodiscard]] inline Image strip(const AnyEstimator& estimate, int width, int height,
                                 const SampleRange& range, const std::atomic<bool>& cancel) {
  const int panel = width / static_cast<int>(strip_samples.size()) + 1;
  Film film(panel / strip_zoom + 1, (height - 1) / strip_zoom + 1);
  Progress progress("strip", std::int64_t{film.width()} * film.height() * strip_samples.back());

  Image image(width, height);
  std::size_t number = 0;
  const auto after_pass = [&](const Film&, const Film& so_far) {
    if (summary(so_far).least == strip_samples[number]) paste(image, developed(so_far), number++);
  };
  render_in_passes(film, close_up_camera(), estimate, strip_samples.back(), range, cancel,
                   after_pass, &progress);
  return image;
}

}  // namespace lt
