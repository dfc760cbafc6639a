/// @file
/// The loop over pixels and samples.
#pragma once

#include <atomic>
#include <concepts>

#include "ch02_ray_casting/camera.hpp"
#include "ch04_monte_carlo/streams.hpp"
#include "ch05_rendering_equation/film.hpp"
#include "common/parallel.hpp"
#include "common/progress.hpp"

namespace lt {

// [estimator]
/// What estimates the radiance along a ray; called from several threads at once.
template <class T>
concept RadianceEstimator = requires(const T& estimate, const Ray& ray, Pcg32& random) {
  { estimate(ray, random) } -> std::same_as<Rgb>;
};
// [estimator]

// [render-options]
/// Which samples to take, and how.
struct SampleRange {
  int first = 0;           ///< number of the first sample of each pixel, >= 0
  int last = 1;            ///< one past the last
  std::uint64_t seed = 1;  ///< the picture is a function of its seed
  int threads = 0;         ///< 0: one for each processor
  int tile_size = 32;      ///< pixels
};
// [render-options]

// [take-sample]
/// One sample of the light that arrives at a pixel, W/(m^2 sr).
/// @param size    of the picture, pixels
/// @param pixel   column and row, from the top left
/// @param sample  its number, >= 0: it has random numbers of its own
template <RadianceEstimator Estimator>
[[nodiscard]] Rgb take_sample(const Camera& camera, const Estimator& estimate, ivec2 size,
                              ivec2 pixel, std::uint64_t seed, int sample) {
  Pcg32 random = stream_for(seed, pixel.x, pixel.y, sample);
  const vec2 within = random.next_vec2();  // anywhere in the pixel: smooth edges for free
  return estimate(camera_ray(camera, vec2(pixel) + within, size.x, size.y), random);
}
// [take-sample]

// [render]
/// Adds samples first to last - 1 of every pixel to `film`. The result is the same, bit for bit,
/// for any number of threads and any tile size.
/// @param cancel    set by anybody: pixels that have not begun are left out
/// @param progress  told of every tile's samples, if there is one
template <RadianceEstimator Estimator>
void render(Film& film, const Camera& camera, const Estimator& estimate, const SampleRange& range,
            const std::atomic<bool>& cancel, Progress* progress = nullptr) {
  const ivec2 size(film.width(), film.height());
  const auto work = [&](const Tile& tile) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        if (cancel) return;  // a pixel gets all of its samples or none
        for (int sample = range.first; sample < range.last; ++sample)
          film.add(x, y, take_sample(camera, estimate, size, {x, y}, range.seed, sample));
      }
    const std::int64_t pixels = std::int64_t{tile.x1 - tile.x0} * (tile.y1 - tile.y0);
    if (progress) progress->advance(pixels * (range.last - range.first));
  };
  for_each_tile(size.x, size.y, range.threads, work, range.tile_size);
}
// [render]

}  // namespace lt
