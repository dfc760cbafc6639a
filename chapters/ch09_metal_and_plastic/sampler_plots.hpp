/// @file
/// What both ways to choose a facet do, as plots.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "ch04_monte_carlo/density_plots.hpp"
#include "ch04_monte_carlo/pcg32.hpp"
#include "ch08_microfacets/albedo.hpp"
#include "ch09_metal_and_plastic/mistakes.hpp"
#include "common/plot.hpp"
#include "common/testkit/sampler_test.hpp"
#include "common/testkit/statistics.hpp"

namespace lt {

/// Facets that reflect everything, so that a weight shows the sampler alone.
template <NormalSampler Normals>
using White = RoughReflection<PerfectMirror, Normals>;

// [weights-of]
/// The weights of `count` samples; 0 for those that lead nowhere.
template <Bsdf AnyBsdf>
[[nodiscard]] std::vector<double> weights_of(const AnyBsdf& bsdf, vec3 wo, int count,
                                             std::uint64_t seed) {
  Pcg32 random(seed);
  std::vector<double> weights;
  for (int i = 0; i < count; ++i) {
    const auto sample = bsdf.sample(wo, random.next_vec3());
    weights.push_back(sample ? sample->weight.g : 0.0f);
  }
  return weights;
}
// [weights-of]

[[nodiscard]] inline std::string name_and_alpha(const std::string& name, float alpha) {
  char text[60];
  std::snprintf(text, sizeof text, "%s \u03b1 %g", name.c_str(), double{alpha});
  return text;
}

// [one-in]
/// The weight that one sample in N exceeds, over N.
[[nodiscard]] inline Series one_in(const std::string& label, std::vector<double> weights) {
  std::sort(weights.begin(), weights.end());  // the largest last
  Series series{label, {}, {}};
  const auto count = static_cast<double>(weights.size());
  for (int i = 5; i <= 60; ++i) {
    const double n = std::pow(10.0, i / 10.0);
    if (n > count) break;
    const auto larger = static_cast<std::size_t>(std::max(1.0, std::floor(count / n)));
    series.add(n, weights[weights.size() - larger]);
  }
  return series;
}
// [one-in]

/// The tails of the weights at cosine 0.1.
[[nodiscard]] inline Plot weights_plot(std::uint64_t seed) {
  Plot plot;
  plot.title = "How large is the largest weight of N samples?";
  plot.x_label = "N: one sample in N weighs more";
  plot.y_label = "weight, seen at cosine 0.1";
  plot.log_x = plot.log_y = true;
  plot.description =
      "Both axes are logarithmic. With visible normals the line stays at 1. With all normals, one "
      "sample in a hundred weighs more than 4 to 7; one in a million more than 10 at alpha 1, 32 "
      "at alpha 0.3 and 74 at alpha 0.1.";
  const vec3 wo = at_cosine(0.1f);
  const auto add = [&](const std::string& name, float alpha, const auto& bsdf) {
    plot.series.push_back(
        one_in(name_and_alpha(name, alpha), weights_of(bsdf, wo, 1'000'000, seed)));
  };
  for (const float alpha : {0.1f, 0.3f, 1.0f})
    add("all,", alpha, White<AllNormals>{{alpha}, {}});
  add("visible,", 0.3f, White<VisibleNormals>{{0.3f}, {}});
  return plot;
}

/// Which facets are chosen, by the cosine between them and the view.
[[nodiscard]] inline Plot facets_plot(std::uint64_t seed) {
  Plot plot = density_axes("Chosen facets, seen at cosine 0.2, \u03b1 0.5",
                           "Two histograms. Of all normals 31 percent show their back: their "
                           "cosine is negative. Visible normals all have positive cosines, "
                           "spread about evenly between 0.3 and 1.");
  plot.x_label = "cosine between facet and view";
  const Ggx ggx{0.5f};
  const vec3 wo = at_cosine(0.2f);
  Pcg32 random(seed);
  std::vector<double> all, visible;
  for (int i = 0; i < 200'000; ++i) {
    const vec2 u = random.next_vec2();
    all.push_back(dot(wo, AllNormals::sample(ggx, wo, u)));
    visible.push_back(dot(wo, VisibleNormals::sample(ggx, wo, u)));
  }
  plot.series.push_back(histogram(all, -1, 1, 40));
  plot.series.back().label = "all";
  plot.series.push_back(histogram(visible, -1, 1, 40));
  plot.series.back().label = "visible";
  return plot;
}

/// The standard deviation of a weight against the cosine of the view.
[[nodiscard]] inline Plot noise_over_angles_plot(std::uint64_t seed) {
  Plot plot;
  plot.title = "Noise of one sample";
  plot.x_label = "cosine of the view";
  plot.y_label = "standard deviation of the weight";
  plot.log_x = plot.log_y = true;
  plot.description =
      "Both axes are logarithmic. From above both samplers are equally noisy. Towards the horizon "
      "the noise of all normals rises above 2, that of visible normals falls below 0.1.";
  const auto add = [&](const std::string& label, const auto& bsdf) {
    Series series{label, {}, {}};
    for (int i = 0; i <= 20; ++i) {
      const auto mu = static_cast<float>(std::pow(10.0, -2.0 + i / 10.0));
      RunningMean mean;
      for (const double weight : weights_of(bsdf, at_cosine(mu), 50'000, seed))
        mean.add(weight);
      series.add(mu, std::sqrt(mean.variance()));
    }
    plot.series.push_back(series);
  };
  for (const float alpha : {0.1f, 0.5f}) {
    add(name_and_alpha("all,", alpha), White<AllNormals>{{alpha}, {}});
    add(name_and_alpha("visible,", alpha), White<VisibleNormals>{{alpha}, {}});
  }
  return plot;
}

/// Chi-square of directions against the density that is claimed for them.
template <Bsdf AnyBsdf>
[[nodiscard]] ChiSquare chi_square_of(const AnyBsdf& bsdf, vec3 wo, int samples,
                                      std::uint64_t seed) {
  Pcg32 random(seed);
  const auto draw = [&]() -> std::optional<vec3> {
    const auto sample = bsdf.sample(wo, random.next_vec3());
    return sample ? std::optional(sample->wi) : std::nullopt;
  };
  const auto pdf = [&](vec3 wi) { return double{bsdf.pdf(wo, wi)}; };
  return test_sampler(draw, pdf, {samples, DirectionBins(24, 32)}).chi_square;
}

/// Right and wrong samplers against the number of samples.
[[nodiscard]] inline Plot reflection_chi_square_plot(std::uint64_t seed) {
  namespace m = mistakes;
  Plot plot;
  plot.title = "Chi-square of directions, cosine 0.5, \u03b1 0.3";
  plot.x_label = "samples";
  plot.y_label = "chi-square / degrees of freedom";
  plot.log_x = plot.log_y = true;
  plot.description =
      "Both axes are logarithmic. Both right samplers stay near 1. A density with the wrong cosine "
      "and samples that are drawn again grow in proportion to the samples.";
  const vec3 wo = at_cosine(0.5f);
  const auto add = [&](const std::string& label, const auto& bsdf) {
    Series series{label, {}, {}, true, true};
    for (double n = 3000; n < 1.1e6; n *= std::sqrt(10.0)) {
      const ChiSquare found = chi_square_of(bsdf, wo, static_cast<int>(n), seed);
      series.add(std::floor(n), found.statistic / found.degrees_of_freedom);
    }
    plot.series.push_back(series);
  };
  const White<AllNormals> all{{0.3f}, {}};
  add("all", all);
  add("visible", White<VisibleNormals>{{0.3f}, {}});
  add("n.o for h.o", m::JacobianAtSurface<PerfectMirror>{all});
  add("redrawn", m::Redrawn<PerfectMirror>{all});
  return plot;
}

/// @param name  weights, facets, noise or chi-square
[[nodiscard]] inline Plot sampler_plot_named(const std::string& name, std::uint64_t seed) {
  if (name == "weights") return weights_plot(seed);
  if (name == "facets") return facets_plot(seed);
  return name == "noise" ? noise_over_angles_plot(seed) : reflection_chi_square_plot(seed);
}

}  // namespace lt
