/// @file
/// What the chapter measures, as plots.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

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

/// noise = scale * samples^slope
struct NoiseLaw {
  double scale;
  double slope;
};

// [fit-noise]
/// The straight line through log(noise) over log(samples), by least squares.
/// @param measured  two at least
[[nodiscard]] inline NoiseLaw fit_noise(const std::vector<NoiseAt>& measured) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const NoiseAt& at : measured) {
    const double u = std::log(at.samples);
    const double v = std::log(at.noise);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  const double slope = (n * xy - x * y) / (n * xx - x * x);
  return {std::exp((y - slope * x) / n), slope};
}
// [fit-noise]

/// The measured noise, and the line through it.
/// @param measured  two at least
[[nodiscard]] inline Plot noise_plot(const std::vector<NoiseAt>& measured) {
  const NoiseLaw law = fit_noise(measured);
  char label[40];
  std::snprintf(label, sizeof label, "slope %.2f", law.slope);
  Series points{"", {}, {}, false, true};
  Series line{label, {}, {}, true, false, 0};
  for (const NoiseAt& at : measured) {
    points.x.push_back(at.samples);
    points.y.push_back(at.noise);
    line.x.push_back(at.samples);
    line.y.push_back(law.scale * std::pow(at.samples, law.slope));
  }
  Plot plot;
  plot.title = "Noise of the room";
  plot.x_label = "samples per pixel";
  plot.y_label = "standard error of a pixel, W/(m\u00b2 sr)";
  plot.log_x = plot.log_y = true;
  plot.description =
      "Dots are measured, the line is fitted, both axes are logarithmic. The noise falls along a "
      "straight line: four times the samples, half the noise.";
  plot.series = {points, line};
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
    Series line{label, {}, {}, true, false, static_cast<int>(plot.series.size())};
    Series dots{"", {}, {}, false, true};
    for (int depth = 0; depth <= 16; ++depth) {
      line.x.push_back(depth);
      line.y.push_back(furnace_radiance(1, albedo, depth));
      dots.x.push_back(depth);
      dots.y.push_back(measure_furnace(albedo, depth, paths, seed).mean());
    }
    plot.series.push_back(dots);
    plot.series.push_back(line);
  }
  return plot;
}

}  // namespace lt
