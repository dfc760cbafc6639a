/// @file
/// Fresnel's equations as curves.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "ch07_fresnel/fresnel.hpp"
#include "ch07_fresnel/metals.hpp"
#include "ch07_fresnel/mistakes.hpp"
#include "ch07_fresnel/schlick.hpp"
#include "ch07_fresnel/special_angles.hpp"
#include "common/plot.hpp"

namespace lt {

inline constexpr double degree = 3.14159265358979323846 / 180;

/// A clear medium, by name.
struct Medium {
  const char* name;
  double ior;
};
inline constexpr Medium clear_media[] = {{"diamond", 2.42}, {"glass", 1.5}, {"water", 1.33}};

// [over-angles]
/// A function of cos(theta), drawn over the angle in degrees; with more points towards `last`,
/// where Fresnel's curves are steep.
template <class F>
[[nodiscard]] Series over_angles(const std::string& label, const F& f, double last = 90) {
  Series series{label, {}, {}};
  for (int i = 0; i <= 180; ++i) {
    const double left = 1 - i / 180.0;
    const double angle = last * (1 - left * left);
    series.x.push_back(angle);
    series.y.push_back(f(std::max(0.0, std::cos(angle * degree))));
  }
  return series;
}
// [over-angles]

/// One marked point, in the color of series `color_of`.
[[nodiscard]] inline Series mark(const std::string& label, double angle, double y, int color_of) {
  return {label, {angle / degree}, {y}, false, true, color_of};
}

/// "name 56.3°"
[[nodiscard]] inline std::string with_degrees(const std::string& name, double angle) {
  char text[60];
  std::snprintf(text, sizeof text, "%s %.1f\u00b0", name.c_str(), angle / degree);
  return text;
}

[[nodiscard]] inline Plot angle_plot(const std::string& title, const std::string& description) {
  Plot plot;
  plot.title = title;
  plot.x_label = "angle to the normal, degrees";
  plot.y_label = "reflected share";
  plot.description = description;
  return plot;
}

/// Both polarisations and their mean, from air into glass.
[[nodiscard]] inline Plot polarised_plot() {
  Plot plot =
      angle_plot("From air to glass, 1.5",
                 "All three curves start at 0.04. Light that swings across the plane of the "
                 "rays is reflected ever more; light that swings in it falls to zero at "
                 "Brewster's angle, 56.3 degrees. The mean is nearly flat up to 50 degrees. "
                 "At 90 degrees everything is reflected.");
  const auto both = [](double c) { return reflectance_dielectric(c, 1.0, 1.5); };
  plot.series = {over_angles("across (s)", [&](double c) { return both(c).s; }),
                 over_angles("mean", [](double c) { return fresnel_dielectric(c, 1.0, 1.5); }),
                 over_angles("in plane (p)", [&](double c) { return both(c).p; })};
  const double brewster = brewster_angle(1.0, 1.5);
  plot.series.push_back(mark(with_degrees("Brewster", brewster), brewster, 0, 2));
  return plot;
}

/// Water, glass and diamond, from outside; Brewster's angles marked.
[[nodiscard]] inline Plot outside_plot() {
  Plot plot = angle_plot("From air into water, glass and diamond",
                         "Reflected share of unpolarised light. At the normal water gives back "
                         "0.02, glass 0.04, diamond 0.17; all rise to 1 at 90 degrees. Dots mark "
                         "Brewster's angles, 53.1, 56.3 and 67.5 degrees.");
  for (const auto& [name, ior] : clear_media) {
    const int number = static_cast<int>(plot.series.size());
    const double brewster = brewster_angle(1.0, ior);
    const double there = fresnel_dielectric(std::cos(brewster), 1.0, ior);
    plot.series.push_back(
        over_angles(name, [n = ior](double c) { return fresnel_dielectric(c, 1.0, n); }));
    plot.series.push_back(mark(with_degrees("", brewster), brewster, there, number));
  }
  return plot;
}

/// The same from inside; critical angles marked.
[[nodiscard]] inline Plot inside_plot() {
  Plot plot = angle_plot("From water, glass and diamond into air",
                         "Reflected share of unpolarised light, seen from inside. Each curve stays "
                         "low and then shoots up to 1 at its critical angle: 24.4 degrees for "
                         "diamond, 41.8 for glass, 48.8 for water. Beyond it all light is "
                         "reflected.");
  for (const auto& [name, ior] : clear_media) {
    const int number = static_cast<int>(plot.series.size());
    const double critical = *critical_angle(ior, 1.0);
    plot.series.push_back(over_angles(
        "", [n = ior](double c) { return fresnel_dielectric(c, n, 1.0); }, critical / degree));
    plot.series.push_back(mark(with_degrees(name, critical), critical, 1, number));
  }
  return plot;
}

/// A metal in blue, red and green: in this order the kit's first three colours fit.
[[nodiscard]] inline Plot metal_plot(const std::string& name, const Metal& metal) {
  Plot plot =
      angle_plot("From air to " + name,
                 "Reflected share for red, green and blue light. It hardly changes up to 60 "
                 "degrees; then all colours rise to 1 at 90 degrees, so that the edge of a "
                 "metal ball is white.");
  const std::pair<const char*, int> channels[] = {{"blue", 2}, {"red", 0}, {"green", 1}};
  for (const auto& [color, channel] : channels)
    plot.series.push_back(over_angles(color, [&, c = channel](double cos_here) {
      return fresnel_conductor(cos_here, 1.0, double{metal.eta[c]}, double{metal.k[c]});
    }));
  return plot;
}

/// Schlick's curves against the exact ones.
[[nodiscard]] inline Plot schlick_plot() {
  Plot plot =
      angle_plot("Schlick's approximation minus the exact share",
                 "Differences over the angle. For glass from outside the approximation is "
                 "too low by up to 0.02 and then too high by up to 0.04; for water and diamond "
                 "likewise, up to 0.06 and 0.08. For the thesis' gold it is too high by up to "
                 "0.02, because it cannot dip before it rises.");
  plot.y_label = "Schlick minus exact";
  for (const auto& [name, ior] : clear_media)
    plot.series.push_back(over_angles(name, [n = ior](double c) {
      return schlick(c, fresnel_dielectric(1.0, 1.0, n)) - fresnel_dielectric(c, 1.0, n);
    }));
  plot.series.push_back(over_angles("thesis' gold", [](double c) {
    return schlick(c, fresnel_conductor(1.0, 1.0, 0.277, 2.92)) -
           fresnel_conductor(c, 1.0, 0.277, 2.92);
  }));
  return plot;
}

/// Thesis eq. 9 as printed and corrected.
[[nodiscard]] inline Plot printed_plot() {
  Plot plot = angle_plot("A metal with the thesis' numbers, 0.277 + 2.92 i",
                         "The right curve lies near 0.89 up to 60 degrees. The formula as printed "
                         "gives 0.73 there: a fifth of the light is lost.");
  plot.series = {
      over_angles("right", [](double c) { return fresnel_conductor(c, 1.0, 0.277, 2.92); }),
      over_angles("as printed", [](double c) {
        return mistakes::fresnel_conductor_as_printed(c, 1.0, 0.277, 2.92);
      })};
  return plot;
}

/// @param name  polarised, outside, inside, gold, silver, copper, schlick or printed
[[nodiscard]] inline Plot curve_plot(const std::string& name) {
  if (name == "polarised") return polarised_plot();
  if (name == "outside") return outside_plot();
  if (name == "inside") return inside_plot();
  if (name == "schlick") return schlick_plot();
  if (name == "printed") return printed_plot();
  return metal_plot(name, name == "silver" ? silver : name == "copper" ? copper : gold);
}

}  // namespace lt
