/// @file
/// Chapter 1's evening, counted photon by photon: every pixel is an estimate.
#pragma once

#include <cstdint>

#include "ch01_pixels/evening.hpp"
#include "ch04_monte_carlo/streams.hpp"
#include "common/parallel.hpp"
#include "common/progress.hpp"

namespace lt {

// [photon]
/// A photon arrives or it does not: 1 with a probability of `light`, else 0, so that its mean is
/// `light`. One number u serves all three colors.
/// @param light  0 to 1 each; what is brighter than white counts as white
/// @param u      in [0, 1)
[[nodiscard]] inline Rgb photon(Rgb light, float u) {
  return {u < light.r ? 1.0f : 0.0f, u < light.g ? 1.0f : 0.0f, u < light.b ? 1.0f : 0.0f};
}
// [photon]

/// Which random numbers a sample gets: stream_for() is right, mistakes.hpp has others.
using StreamOf = Pcg32 (*)(std::uint64_t seed, int x, int y, int sample);

/// How to count.
struct PhotonOptions {
  int width = 900;                  ///< pixels
  int height = 720;                 ///< pixels
  int samples_per_pixel = 16;       ///< at least 1
  bool is_strip = false;            ///< 1, 4, 16, 64 and 256 samples from left to right instead
  bool is_stratified = false;       ///< one u in each of samples_per_pixel parts of [0, 1)
  std::uint64_t seed = 1;           ///< the picture is a function of its seed
  int threads = 0;                  ///< 0: one for each processor
  StreamOf stream_of = stream_for;  ///< what a sample draws from
};

// [photon-pixel]
/// The mean of a pixel's samples.
[[nodiscard]] inline Rgb photon_pixel(const PhotonOptions& options, Rgb light, int x, int y,
                                      int samples) {
  Rgb sum(0.0f);
  for (int i = 0; i < samples; ++i) {
    Pcg32 random = options.stream_of(options.seed, x, y, i);
    float u = random.next_float();
    if (options.is_stratified) u = (static_cast<float>(i) + u) / static_cast<float>(samples);
    sum += photon(light, u);
  }
  return sum / static_cast<float>(samples);
}
// [photon-pixel]

/// 1, 4, 16, 64, 256 in five bands of the picture.
[[nodiscard]] inline int samples_of_band(int x, int width) {
  return 1 << 2 * (5 * x / width);
}

/// The evening. The same for any number of threads.
/// @param progress  hears of every pixel; may be nullptr
[[nodiscard]] inline Image photon_picture(const PhotonOptions& options,
                                          Progress* progress = nullptr) {
  Image image = evening_picture(options.width, options.height);
  for_each_tile(options.width, options.height, options.threads, [&](const Tile& tile) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        const int samples =
            options.is_strip ? samples_of_band(x, options.width) : options.samples_per_pixel;
        image.at(x, y) = photon_pixel(options, image.at(x, y), x, y, samples);
      }
    if (progress) progress->advance((tile.x1 - tile.x0) * (tile.y1 - tile.y0));
  });
  return image;
}

}  // namespace lt
