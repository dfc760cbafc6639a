/// @file
/// The room, rendered with both samplers side by side.
#pragma once

#include <cmath>

#include "ch05_rendering_equation/views.hpp"
#include "ch06_importance_sampling/diverging_color.hpp"
#include "ch06_importance_sampling/efficiency.hpp"
#include "ch06_importance_sampling/sampled_room.hpp"

namespace lt {

/// What the pair and the map are made of.
struct PairOptions {
  int width, height;       ///< pixels
  int uniform_samples;     ///< per pixel, for the uniform sampler
  int cosine_samples;      ///< per pixel, for the other
  std::uint64_t seed = 1;  ///< of both
  int threads = 0;         ///< 0: one for each processor
};

// [pair]
/// The uniform sampler's picture on the left, the cosine's on the right.
[[nodiscard]] inline Image pair_picture(const SampledRoom& room, SampledRoomOptions how,
                                        const Camera& camera, const PairOptions& options,
                                        const std::atomic<bool>& cancel) {
  const auto& [width, height, uniform_samples, cosine_samples, seed, threads] = options;
  const int left = std::max(1, width / 2 - 1);  // two columns between them stay white
  const int right = std::max(1, width - left - 2);
  Progress progress("pair",
                    std::int64_t{height} * (left * uniform_samples + right * cosine_samples));
  Image image(width, height, Rgb(1.0f));
  for (const bool is_uniform : {true, false}) {
    how.sampler = is_uniform ? "uniform" : "cosine";
    Film film(is_uniform ? left : right, height);
    const int samples = is_uniform ? uniform_samples : cosine_samples;
    render(film, camera, estimator_for(room, how),
           {.last = samples, .seed = seed, .threads = threads}, cancel, &progress);
    require_good_samples(film);
    paste_at(image, developed(film), is_uniform ? 0 : width - film.width());
  }
  return image;
}
// [pair]

// [gain]
/// How many times as large a pixel's variance is with the uniform sampler, as a mean over its 24
/// neighbours too, which the noise of a variance needs; 0 where neither has any.
[[nodiscard]] inline double gain_at(const Image& uniform, const Image& cosine, int x, int y) {
  double sums[2] = {0, 0};
  for (int j = std::max(0, y - 2); j <= std::min(uniform.height() - 1, y + 2); ++j)
    for (int i = std::max(0, x - 2); i <= std::min(uniform.width() - 1, x + 2); ++i) {
      sums[0] += dot(uniform.at(i, j), Rgb(1.0f));
      sums[1] += dot(cosine.at(i, j), Rgb(1.0f));
    }
  return sums[1] > 0 ? sums[0] / sums[1] : 0;
}

/// Grey where both samplers are as noisy, orange where the cosine's is less so, blue where it is
/// more so; full colour at a factor of 3. Black where there is no noise.
[[nodiscard]] inline Rgb gain_color(double gain) {
  if (gain == 0) return Rgb(0.0f);
  return diverging_color(std::log(gain) / std::log(3.0));
}
// [gain]

inline constexpr int gain_zoom = 4;  ///< pixels of the map along a side of one of the room's

/// A map of the gain.
[[nodiscard]] inline Image gain_picture(const SampledRoom& room, SampledRoomOptions how,
                                        const Camera& camera, const PairOptions& options) {
  const int width = (options.width - 1) / gain_zoom + 1;
  const int height = (options.height - 1) / gain_zoom + 1;
  const auto variances = [&](const std::string& sampler, int samples) {
    how.sampler = sampler;
    const SampleRange range{.last = samples, .seed = options.seed, .threads = options.threads};
    return pixel_variances(camera, estimator_for(room, how), width, height, range);
  };
  const Image uniform = variances("uniform", options.uniform_samples);
  const Image cosine = variances("cosine", options.cosine_samples);
  Image image(options.width, options.height);
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x)
      image.at(x, y) = gain_color(gain_at(uniform, cosine, x / gain_zoom, y / gain_zoom));
  return image;
}

}  // namespace lt
