/// @file
/// Rough glass, and what is printed of it, as curves.
#pragma once

#include <string>

#include "ch07_fresnel/curve_plots.hpp"
#include "ch10_dielectric/coat_plots.hpp"
#include "ch11_refraction/glass_scenes.hpp"
#include "ch11_refraction/interface_energy.hpp"
#include "ch11_refraction/media.hpp"
#include "ch11_refraction/mistakes.hpp"

namespace lt {

// [through-plot]
/// How much light from each direction below counts, in the plane of wo and the normal.
/// @param degrees  the angle of wo
[[nodiscard]] inline Series through_curve(float alpha, double degrees, float n_here,
                                          float n_beyond) {
  const RoughGlass<> glass{{alpha}, n_here, n_beyond};
  const vec3 wo = at_angle(-degrees);
  const auto counted = [&](vec3 w) { return glass.eval(wo, {w.x, w.y, -w.z}).g * w.z; };
  return over_angle(with_alpha("\u03b1 ", alpha), counted, 89, 178);
}
// [through-plot]

[[nodiscard]] inline Plot through_plot() {
  Plot plot = angle_plot("Into rough glass, from 60\u00b0",
                         "Three lobes near 35 degrees, where a smooth surface would send the "
                         "ray. The lobe of alpha 0.2 is a peak of 12 at 37 degrees, that of 0.3 "
                         "reaches 5 at 38; that of 0.5 is broad and low, and lies farther from the "
                         "normal, near 43.");
  plot.x_label = "angle of the ray in the glass, degrees";
  plot.y_label = "BTDF times cosine, 1/sr";
  for (const float alpha : {0.2f, 0.3f, 0.5f})
    plot.series.push_back(through_curve(alpha, 60, index_of_air, 1.5f));
  return plot;
}

/// Thesis eq. 16: the angle behind the surface.
[[nodiscard]] inline Plot root_plot() {
  Plot plot = angle_plot("Thesis equation 16: where the ray goes",
                         "From air into glass, both curves start at 0; the right one levels "
                         "off at 41.8 degrees, the printed one at 49. From glass into air "
                         "the right one rises to 90 degrees at 41.8, the printed one only at "
                         "54.7.");
  plot.y_label = "angle beyond, degrees";
  const auto beyond = [](const std::optional<vec3>& wi) {
    const vec3 unit = normalize(*wi);
    return std::atan2(std::hypot(double{unit.x}, double{unit.y}), -double{unit.z}) / degree;
  };
  const auto add = [&](const std::string& label, bool printed, float eta, double last, int color) {
    Series series{label, {}, {}, true, false, color};
    for (int i = 0; i <= 120; ++i) {
      const double left = 1 - i / 120.0;
      const double angle = last * (1 - left * left);
      const vec3 wo = at_angle(angle), up(0, 0, 1);
      const auto wi =
          printed ? mistakes::refracted_as_printed(wo, up, eta) : refracted(wo, up, eta);
      if (wi) series.add(angle, beyond(wi));
    }
    plot.series.push_back(series);
  };
  add("into glass", false, 1 / 1.5f, 89.9, 0);
  add("as printed", true, 1 / 1.5f, 89.9, 1);
  add("out of glass", false, 1.5f, 41.81, 2);
  add("as printed", true, 1.5f, 54.73, 3);
  return plot;
}

/// What a surface lets go anywhere, from both sides.
[[nodiscard]] inline Plot energy_both_ways_plot() {
  Plot plot = cosine_plot(
      "Rough glass: reflected and let through together", "share of the light",
      "Six curves, none above 1. From above alpha 0.1 loses a thousandth on the way in and a "
      "hundredth on the way out, alpha 0.3 a hundredth and a tenth, alpha 1 a tenth and 0.58. "
      "Towards the horizon, on the left, more is lost, most for alpha 1: 0.6.");
  for (const bool outside : {true, false})
    for (const float alpha : {0.1f, 0.3f, 1.0f}) {
      const RoughGlass<> glass{{alpha}, outside ? 1.0f : 1.5f, outside ? 1.5f : 1.0f};
      plot.series.push_back(over_cosine(
          with_alpha(outside ? "in, \u03b1 " : "out, \u03b1 ", alpha),
          [&](float mu) { return interface_energy(glass, mu, 60).total(); }, 40));
    }
  return plot;
}

/// Thesis eq. 17: what comes of 1.
[[nodiscard]] inline Plot weight_plot() {
  Plot plot = cosine_plot(
      "Thesis equation 17: what comes of 1", "reflected and let through",
      "The right curves stay below 1. With the printed weights both surfaces give 1.04 from above. "
      "Towards the horizon, on the left, alpha 0.1 rises to 1.3 at the cosine 0.1 and to 1.4 "
      "beyond; alpha 0.3 stays near 1.05.");
  for (const float alpha : {0.1f, 0.3f}) {
    const RoughGlass<> glass{{alpha}, 1.0f, 1.5f};
    plot.series.push_back(over_cosine(
        with_alpha("right, \u03b1 ", alpha),
        [&](float mu) { return interface_energy(glass, mu, 80).total(); }, 40));
    plot.series.push_back(over_cosine(
        with_alpha("printed, \u03b1 ", alpha),
        [&](float mu) {
          const InterfaceEnergy energy = interface_energy(glass, mu, 80);
          return energy.reflected + energy.unreduced;
        },
        40));
  }
  return plot;
}

/// The thesis' clear sphere: what is left of each colour.
[[nodiscard]] inline Plot beer_plot() {
  Plot plot;
  plot.title = "Through the thesis' clear sphere";
  plot.x_label = "way through, metres";
  plot.y_label = "share that is left";
  plot.description =
      "Red stays at 1. Blue falls along an exponential to 0.39 at 1.4 metres, the sphere's "
      "diameter, and green to 0.25.";
  const TexturedScene room = three_sphere_room_plain();
  const Rgb attenuation = room.looks[room::clear_sphere].material.attenuation;
  const std::pair<const char*, int> channels[] = {{"blue", 2}, {"red", 0}, {"green", 1}};
  for (const auto& [name, channel] : channels) {
    Series series{name, {}, {}};
    for (int i = 0; i <= 56; ++i)
      series.add(i * 0.025, transmittance(attenuation, static_cast<float>(i) * 0.025f)[channel]);
    plot.series.push_back(series);
  }
  return plot;
}

/// @param name  through, root, energy, weight or beer
[[nodiscard]] inline Plot glass_plot_named(const std::string& name) {
  if (name == "through") return through_plot();
  if (name == "root") return root_plot();
  if (name == "energy") return energy_both_ways_plot();
  return name == "weight" ? weight_plot() : beer_plot();
}

}  // namespace lt
