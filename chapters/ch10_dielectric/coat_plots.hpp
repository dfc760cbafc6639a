/// @file
/// Energy and noise of coats, as curves.
#pragma once

#include <string>

#include "ch08_microfacets/microfacet_plots.hpp"
#include "ch10_dielectric/choice_price.hpp"
#include "ch10_dielectric/total_albedo.hpp"

namespace lt {

// [over-cosine]
/// A function of the cosine, with more points near the horizon, where it is steep.
template <class F>
[[nodiscard]] Series over_cosine(const std::string& label, const F& f, int steps = 60) {
  Series series{label, {}, {}};
  for (int i = 1; i <= steps; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(steps);
    series.add(t * t, f(t * t));
  }
  return series;
}
// [over-cosine]

inline constexpr float plot_alphas[] = {0.0f, 0.1f, 0.3f, 1.0f};

/// "smooth", or "α 0.3"
[[nodiscard]] inline std::string alpha_label(float alpha) {
  return alpha == 0.0f ? "smooth" : with_alpha("\u03b1 ", alpha);
}

[[nodiscard]] inline Plot cosine_plot(const std::string& title, const std::string& y_label,
                                      const std::string& description) {
  Plot plot;
  plot.title = title;
  plot.x_label = "cosine of the angle to the surface's normal";
  plot.y_label = y_label;
  plot.description = description;
  return plot;
}

/// E of coats.
[[nodiscard]] inline Plot coat_plot() {
  Plot plot = cosine_plot(
      "What a coat of index 1.5 reflects: E", "share of the light",
      "From above coats reflect 0.04, the rough ones less, down to 0.013. Towards the horizon, on "
      "the left, the smooth coat rises to 1, that of alpha 0.1 to about 0.4, and the roughest "
      "stays below 0.1.");
  for (const float alpha : plot_alphas)
    plot.series.push_back(over_cosine(alpha_label(alpha), [&](float mu) {
      const CoatFresnel coat{1.5f};
      if (alpha == 0.0f) return double{coat.share(mu)};
      return specular_albedo(Coat<>{{alpha}, coat}, mu, 100);
    }));
  return plot;
}

/// Totals of white bodies with the thesis' base.
[[nodiscard]] inline Plot printed_totals_plot() {
  Plot plot = cosine_plot(
      "Thesis equation 7: what comes back of 1", "albedo of coat and white base",
      "No curve should be above 1. From above all are at 0.93 to 0.96. Towards the horizon, on the "
      "left, the smooth coat crosses 1 at the cosine 0.47 and is at 1.44 at 0.1; alpha 0.1 reaches "
      "1.2, alpha 0.3 1.02; alpha 1 stays at 0.91.");
  for (const float alpha : plot_alphas)
    plot.series.push_back(over_cosine(
        alpha_label(alpha), [&](float mu) { return white_total("thesis", alpha, mu, 120); }));
  return plot;
}

/// Totals of white bodies with both repairs.
[[nodiscard]] inline Plot repairs_plot() {
  Plot plot = cosine_plot(
      "Two repairs: what comes back of 1", "albedo of coat and white base",
      "Four curves of the reciprocal base stay below 1, at 0.88 to 0.91 from above; towards the "
      "horizon, on the left, the smooth one rises to 1, and the rougher the coat, the deeper a "
      "curve falls. The conserving base is a flat line at 1 for every alpha.");
  for (const float alpha : plot_alphas)
    plot.series.push_back(over_cosine(
        alpha_label(alpha), [&](float mu) { return white_total("reciprocal", alpha, mu, 120); }));
  plot.series.push_back(over_cosine(
      "conserving, \u03b1 0.3", [](float mu) { return white_total("conserving", 0.3f, mu, 60); },
      30));
  return plot;
}

// [choice-plot]
/// Variance against the probability of the coat, from three angles; what ByShare takes is marked.
[[nodiscard]] inline Plot choice_plot() {
  Plot plot;
  plot.title = "The price of a choice";
  plot.x_label = "probability of choosing the coat";
  plot.y_label = "variance of a sample's weight";
  plot.log_y = true;
  plot.description =
      "A grey body under a coat of alpha 0.1, from three angles. Every curve falls to a sharp "
      "minimum and rises on both sides by powers of ten. The minimum lies at a probability near "
      "0.08 "
      "from above and near 0.7 from the cosine 0.1. The marked choices by share lie close to the "
      "minima.";
  for (const float mu : {1.0f, 0.3f, 0.1f}) {
    const auto variance = [&](const auto& choice) {
      return weight_moments(grey_coated(0.1f, choice), at_cosine(mu), 100).variance;
    };
    Series series{with_alpha("cosine ", mu), {}, {}};
    for (int i = 1; i < 50; ++i)
      series.add(i / 50.0, variance(FixedChoice{static_cast<float>(i) / 50.0f}));
    const float by_share = grey_coated(0.1f, ByShare{}).coat_probability(at_cosine(mu));
    const int color = static_cast<int>(plot.series.size());
    plot.series.push_back(series);
    plot.series.push_back({"", {by_share}, {variance(ByShare{})}, false, true, color});
  }
  return plot;
}
// [choice-plot]

/// @param name  coat, printed, repairs or choice
[[nodiscard]] inline Plot coat_plot_named(const std::string& name) {
  if (name == "coat") return coat_plot();
  if (name == "printed") return printed_totals_plot();
  return name == "repairs" ? repairs_plot() : choice_plot();
}

}  // namespace lt
