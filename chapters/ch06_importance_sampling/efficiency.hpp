/// @file
/// Which of two estimators is better? The one that needs less time for the same noise.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "ch05_rendering_equation/progressive.hpp"
#include "common/testkit/statistics.hpp"
#include "common/timing.hpp"

namespace lt {

// [sample-cost]
/// What one sample of a pixel costs, and how far it strays.
struct SampleCost {
  double variance;  ///< of one sample, mean over pixels and colours, (W/(m^2 sr))^2
  double seconds;   ///< processor time of one sample
};

/// 1 / (variance x time). Time t buys t / seconds samples, and their mean has the variance
/// variance seconds / t: an estimator of twice the efficiency needs half the time for the same
/// noise.
[[nodiscard]] inline double efficiency(const SampleCost& cost) {
  return 1.0 / (cost.variance * cost.seconds);
}
// [sample-cost]

// [pixel-variances]
/// The variance of one sample of each pixel, for each colour, (W/(m^2 sr))^2.
/// @param range  first to last - 1 are the samples; at least two
template <RadianceEstimator Estimator>
[[nodiscard]] Image pixel_variances(const Camera& camera, const Estimator& estimate, int width,
                                    int height, const SampleRange& range) {
  const ivec2 size(width, height);
  Image variances(width, height);
  const auto work = [&](const Tile& tile) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        // [one-variance]
        std::array<RunningMean, 3> colors;
        for (int i = range.first; i < range.last; ++i) {
          const Rgb sample = take_sample(camera, estimate, size, {x, y}, range.seed, i);
          for (int c = 0; c < 3; ++c)
            colors[c].add(sample[c]);
        }
        for (int c = 0; c < 3; ++c)
          variances.at(x, y)[c] = static_cast<float>(colors[c].variance());
        // [one-variance]
      }
  };
  for_each_tile(width, height, range.threads, work, range.tile_size);
  return variances;
}
// [pixel-variances]

/// The mean over pixels and colours.
[[nodiscard]] inline double mean_of(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c)
        sum += image.at(x, y)[c];
  return sum / (3.0 * image.width() * image.height());
}

// [measure-cost]
/// Measures both. The time is the processor's, that of all threads together.
template <RadianceEstimator Estimator>
[[nodiscard]] SampleCost measure_cost(const Camera& camera, const Estimator& estimate, int width,
                                      int height, const SampleRange& range) {
  const ProcessorTimer timer;
  const Image variances = pixel_variances(camera, estimate, width, height, range);
  const double seconds = timer.seconds();
  const double samples = static_cast<double>(width) * height * (range.last - range.first);
  return {mean_of(variances), seconds / samples};
}
// [measure-cost]

}  // namespace lt
