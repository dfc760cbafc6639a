/// @file
/// D, G and what comes of them, as curves.
#pragma once

#include <cstdio>
#include <string>

#include "ch08_microfacets/albedo.hpp"
#include "ch08_microfacets/lobe_plots.hpp"
#include "common/plot.hpp"

namespace lt {

// [over-angle]
/// A function of a direction, drawn over its angle to the normal, 0 to 90 degrees.
template <class F>
[[nodiscard]] Series over_angle(const std::string& label, const F& f, double last = 90,
                                int steps = 180) {
  Series series{label, {}, {}};
  for (int i = 0; i <= steps; ++i)
    series.add(last * i / steps, f(at_angle(last * i / steps)));
  return series;
}
// [over-angle]

/// "name 0.4"
[[nodiscard]] inline std::string with_alpha(const std::string& name, float alpha) {
  char text[40];
  std::snprintf(text, sizeof text, "%s%.1f", name.c_str(), alpha);
  return text;
}

[[nodiscard]] inline Plot microfacet_plot(const std::string& title, const std::string& y_label,
                                          const std::string& description) {
  Plot plot;
  plot.title = title;
  plot.x_label = "angle to the surface's normal, degrees";
  plot.y_label = y_label;
  plot.description = description;
  return plot;
}

/// D against the angle of the facets.
[[nodiscard]] inline Plot d_plot() {
  Plot plot = microfacet_plot(
      "How facets lean: D for five alphas", "D, 1/sr",
      "A logarithmic axis. For alpha 0.1 the curve starts at 32 and has lost four powers of "
      "ten at 80 degrees; for alpha 1 it is flat at 0.32: all facets are equally frequent. Every "
      "curve has a long tail and none falls to 0.");
  plot.log_y = true;
  for (const float alpha : lobe_alphas)
    plot.series.push_back(over_angle(
        with_alpha("\u03b1 ", alpha), [&](vec3 h) { return Ggx{alpha}.d(h); }, 89.9));
  return plot;
}

/// G1 against the angle of whoever looks.
[[nodiscard]] inline Plot g1_plot() {
  Plot plot = microfacet_plot(
      "How much one sees: G1 for five alphas", "share of the facets that is seen",
      "All curves are 1 at the normal and fall to 0 at 90 degrees. For alpha 0.1 the curve stays "
      "near 1 up to 70 degrees and then drops; for alpha 1 it falls from the beginning.");
  for (const float alpha : lobe_alphas)
    plot.series.push_back(
        over_angle(with_alpha("\u03b1 ", alpha), [&](vec3 w) { return g1(Ggx{alpha}, w, w); }));
  return plot;
}

/// Both forms of G2, light and eye at equal angles on opposite sides.
[[nodiscard]] inline Plot g2_plot() {
  Plot plot = microfacet_plot(
      "Seen and lit: both forms of G2", "share of the facets that is seen and lit",
      "Light and eye at the same angle on opposite sides, for alpha 0.4 and 1. Between 0 and 90 "
      "degrees the correlated form lies above the separable one; for alpha 1, both at 75 degrees, "
      "it is 0.26 for 0.17.");
  for (const float alpha : {0.4f, 1.0f}) {
    plot.series.push_back(over_angle(with_alpha("correlated ", alpha), [&](vec3 w) {
      return g2_correlated(Ggx{alpha}, w, {-w.x, 0.0f, w.z});
    }));
    plot.series.push_back(over_angle(with_alpha("separable ", alpha), [&](vec3 w) {
      return g2_separable(Ggx{alpha}, w, {-w.x, 0.0f, w.z});
    }));
  }
  return plot;
}

/// The albedo of perfect mirrors.
[[nodiscard]] inline double white_albedo(const BrdfOptions& options, float alpha, vec3 wo,
                                         int steps) {
  return albedo(brdf_named(options, Ggx{alpha}, PerfectMirror{}), alpha, wo, steps);
}

/// What perfect mirrors give back against the angle from which one looks.
[[nodiscard]] inline Plot energy_plot() {
  Plot plot = microfacet_plot(
      "What rough mirrors give back", "albedo of facets that reflect everything",
      "Every curve would be 1 if no light were lost. For alpha 0.1 it stays above 0.87; for alpha "
      "0.4 it is 0.79 at the normal; for alpha 1 it begins at 0.31 and rises to 1 at 90 degrees. "
      "What is missing would have met a second facet.");
  for (const float alpha : lobe_alphas)
    plot.series.push_back(over_angle(
        with_alpha("\u03b1 ", alpha), [&](vec3 wo) { return white_albedo({}, alpha, wo, 250); },
        89.5, 60));
  return plot;
}

/// The same with D as printed, and with the thesis' own G2, the separable one.
[[nodiscard]] inline Plot printed_energy_plot() {
  Plot plot = microfacet_plot(
      "Thesis equation 6: what rough mirrors give back", "albedo of facets that reflect everything",
      "A logarithmic axis. All curves have the thesis' own G2, the separable one. The right ones "
      "stay below 1, at 0.8 and more. As printed, the surface gives back a "
      "quarter of the light at the normal and ever more towards the rim: for alpha 0.1 more than "
      "all of it beyond 76 degrees, and four times as much as arrives at 89.");
  plot.log_y = true;
  for (const float alpha : {0.1f, 0.3f})
    for (const char* wrong : {"none", "printed"}) {
      const bool is_right = wrong == std::string("none");
      plot.series.push_back(over_angle(
          with_alpha(is_right ? "right, \u03b1 " : "as printed, \u03b1 ", alpha),
          [&](vec3 wo) {
            return white_albedo({"separable", wrong}, alpha, wo, 300);
          },
          89, 60));
    }
  return plot;
}

/// @param name  d, g1, g2, energy or printed
[[nodiscard]] inline Plot microfacet_plot_named(const std::string& name) {
  if (name == "d") return d_plot();
  if (name == "g1") return g1_plot();
  if (name == "g2") return g2_plot();
  return name == "energy" ? energy_plot() : printed_energy_plot();
}

}  // namespace lt
