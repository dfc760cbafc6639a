/// @file
/// What the chapter measures, as plots.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "ch04_monte_carlo/density_plots.hpp"
#include "ch05_rendering_equation/plots.hpp"
#include "ch06_importance_sampling/samplers.hpp"
#include "common/plot.hpp"

namespace lt {

/// The heights z of both samplers' directions, against their densities.
/// @param count  directions of each
[[nodiscard]] inline Plot heights_plot(int count, std::uint64_t seed) {
  Plot plot = density_axes("How high do directions point?",
                           "Two histograms of the height z between 0 and 1. Uniform directions "
                           "have the density 1 everywhere. Cosine-weighted ones follow the line "
                           "2z: none at the horizon, twice as many as uniform at the top.");
  plot.x_label = "z = cos \u03b8 of a direction";
  Pcg32 random(seed);
  for (const std::string name : {"uniform", "cosine"}) {
    std::vector<double> heights;
    for (int i = 0; i < count; ++i)
      heights.push_back(sampler_named(name, "none").sample(random.next_vec2()).z);
    Series steps = histogram(heights, 0, 1, 25);
    steps.label = "";
    Series line = name == "uniform" ? curve(
                                          "uniform: 1", [](double) { return 1.0; }, 0, 1)
                                    : curve(
                                          "cosine: 2z", [](double z) { return 2 * z; }, 0, 1);
    line.color_of = static_cast<int>(plot.series.size());
    plot.series.push_back(steps);
    plot.series.push_back(line);
  }
  return plot;
}

/// Measured points of noise and the fitted law, in one colour.
inline void add_noise(Plot& plot, const std::string& name, const std::vector<NoiseAt>& measured) {
  const PowerLaw law = law_of(measured);
  add_dots_and_line(plot, points_of(measured), name,
                    [&](double samples) { return law.at(samples); });
}

/// The noise of both samplers against samples per pixel.
[[nodiscard]] inline Plot noise_plot(const std::vector<NoiseAt>& uniform,
                                     const std::vector<NoiseAt>& cosine) {
  Plot plot;
  plot.title = "Noise of the room with both samplers";
  plot.x_label = "samples per pixel";
  plot.y_label = "standard error of a pixel, W/(m\u00b2 sr)";
  plot.log_x = plot.log_y = true;
  plot.description =
      "Dots are measured, lines are fitted, both axes are logarithmic. Both samplers' noise falls "
      "with the same slope of minus one half; the cosine's line lies lower all the way.";
  add_noise(plot, "uniform", uniform);
  add_noise(plot, "cosine", cosine);
  return plot;
}

// [growth]
/// Chi-square, divided by its degrees of freedom, of 10^3 to 10^6 samples.
[[nodiscard]] inline Series chi_square_growth(const NamedSampler& sampler, std::uint64_t seed) {
  Series series{sampler.name, {}, {}, true, true};
  const DirectionBins bins(8, 8);
  Pcg32 random(seed);
  for (double n = 1000; n < 1.1e6; n *= std::sqrt(10.0)) {
    const ChiSquare found = report_on(sampler, static_cast<int>(n), bins, random).chi_square;
    series.add(std::floor(n), found.statistic / found.degrees_of_freedom);
  }
  return series;
}
// [growth]

/// Right samplers and wrong ones, against the number of samples.
[[nodiscard]] inline Plot chi_square_plot(std::uint64_t seed) {
  Plot plot;
  plot.title = "Chi-square of right and wrong samplers";
  plot.x_label = "samples";
  plot.y_label = "chi-square / degrees of freedom";
  plot.log_x = plot.log_y = true;
  plot.description =
      "Both axes are logarithmic. For the uniform and the cosine-weighted sampler the ratio stays "
      "near 1, however many samples there are. For directions that do not have the density that "
      "they claim it grows in proportion to the samples, a hundredfold and a thousandfold.";
  for (const auto& [name, wrong] : {std::pair{"uniform", "none"}, std::pair{"cosine", "none"},
                                    std::pair{"cosine", "root"}, std::pair{"cosine", "both"}})
    plot.series.push_back(chi_square_growth(sampler_named(name, wrong), seed++));
  return plot;
}

}  // namespace lt
