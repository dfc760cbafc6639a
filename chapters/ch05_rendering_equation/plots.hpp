/// @file
/// What the chapter measures, as plots.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "ch04_monte_carlo/slope.hpp"
#include "ch05_rendering_equation/furnace.hpp"
#include "ch05_rendering_equation/progressive.hpp"
#include "ch05_rendering_equation/radiance.hpp"
#include "ch05_rendering_equation/uniform_lambert.hpp"
#include "common/plot.hpp"
#include "common/testkit/statistics.hpp"

namespace lt {

/// The noise of a picture after so many samples of each pixel.
struct NoiseAt {
  double samples;
  double noise;  ///< W/(m^2 sr)
};

// [measure-noise]
/// The noise after 2, 4, 8, ... samples.
template <RadianceEstimator Estimator>
[[nodiscard]] std::vector<NoiseAt> measure_noise(const Camera& camera, const Estimator& estimate,
                                                 int width, int height, int samples,
                                                 const SampleRange& range,
                                                 const std::atomic<bool>& cancel) {
  std::vector<NoiseAt> measured;
  Film film(width, height);
  Progress progress("noise", std::int64_t{width} * height * samples);
  const auto after_pass = [&](const Film& before, const Film& all) {
    const auto found = pixel_noise(before, all);
    if (found) measured.push_back({static_cast<double>(all.at(0, 0).count), *found});
  };
  render_in_passes(film, camera, estimate, samples, range, cancel, after_pass, &progress);
  return measured;
}
// [measure-noise]

/// Measured noise as points.
[[nodiscard]] inline Series points_of(const std::vector<NoiseAt>& measured) {
  Series points;
  for (const NoiseAt& at : measured)
    points.add(at.samples, at.noise);
  return points;
}

/// The power law that the noise follows.
/// @param measured  three at least
[[nodiscard]] inline PowerLaw law_of(const std::vector<NoiseAt>& measured) {
  const Series points = points_of(measured);
  return fit_power_law(points.x, points.y);
}

/// The measured noise, and the line through it.
/// @param measured  three at least
[[nodiscard]] inline Plot noise_plot(const std::vector<NoiseAt>& measured) {
  const PowerLaw law = law_of(measured);
  char label[40];
  std::snprintf(label, sizeof label, "slope %.2f", law.slope);
  Plot plot;
  plot.title = "Noise of the room";
  plot.x_label = "samples per pixel";
  plot.y_label = "standard error of a pixel, W/(m\u00b2 sr)";
  plot.log_x = plot.log_y = true;
  plot.description =
      "Dots are measured, the line is fitted, both axes are logarithmic. The noise falls along a "
      "straight line: four times the samples, half the noise.";
  add_dots_and_line(plot, points_of(measured), label,
                    [&](double samples) { return law.at(samples); });
  return plot;
}

// [measure-furnace]
/// Mean of `paths` estimates from the middle of a furnace.
/// @param albedo  0 to 1; every wall emits 1 W/(m^2 sr)
[[nodiscard]] inline RunningMean measure_furnace(float albedo, int depth, int paths,
                                                 std::uint64_t seed) {
  const HollowSphere furnace{{.emission = Rgb(1.0f), .tint = Rgb(albedo)}};
  RunningMean mean;
  for (int path = 0; path < paths; ++path) {
    Pcg32 random = stream_for(seed, depth, 0, path);
    const Ray ray{vec3(0.0f), uniform_hemisphere(random.next_vec2())};
    mean.add(radiance_recursive(furnace, uniform_lambert_at, ray, depth, random).g);
  }
  return mean;
}
// [measure-furnace]

/// The furnace's radiance against the depth limit: measured, and in closed form.
[[nodiscard]] inline Plot furnace_plot(int paths, std::uint64_t seed) {
  Plot plot;
  plot.title = "A furnace, and what a depth limit leaves out";
  plot.x_label = "depth: scattering events at most";
  plot.y_label = "radiance, W/(m\u00b2 sr)";
  plot.description =
      "Dots are measured, lines are the closed form. With albedo 0.5 the radiance levels off at 2 "
      "after six events; with albedo 0.8 it is still 3 percent short of its limit 5 after fifteen.";
  for (const float albedo : {0.8f, 0.5f}) {
    char label[40];
    std::snprintf(label, sizeof label, "albedo %.1f", albedo);
    Series measured;
    for (int depth = 0; depth <= 16; ++depth)
      measured.add(depth, measure_furnace(albedo, depth, paths, seed).mean());
    add_dots_and_line(plot, measured, label, [=](double depth) {
      return furnace_radiance(1, albedo, static_cast<int>(depth));
    });
  }
  return plot;
}

}  // namespace lt
