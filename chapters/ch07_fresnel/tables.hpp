/// @file
/// Fresnel's equations as numbers.
#pragma once

#include <cstdio>
#include <string>

#include "ch07_fresnel/curve_plots.hpp"

namespace lt {

/// Reflected shares of water, glass and diamond at some angles, from both sides; of metals, too.
[[nodiscard]] inline std::string reflectance_table() {
  std::string text = "                   0     30     45     60     75     85 degrees\n";
  const auto row = [&](const std::string& name, const auto& f) {
    char cell[40];
    std::snprintf(cell, sizeof cell, "%-15s", name.c_str());
    text += cell;
    for (const double angle : {0, 30, 45, 60, 75, 85}) {
      std::snprintf(cell, sizeof cell, " %6.4f", f(std::cos(angle * degree)));
      text += cell;
    }
    text += '\n';
  };
  for (const auto& [name, ior] : clear_media) {
    row(name, [n = ior](double c) { return fresnel_dielectric(c, 1.0, n); });
    row("  Schlick", [n = ior](double c) { return schlick(c, fresnel_dielectric(1.0, 1.0, n)); });
    row(std::string(name) + ", inside",
        [n = ior](double c) { return fresnel_dielectric(c, n, 1.0); });
  }
  const auto metal_row = [&](const std::string& name, double eta, double k) {
    row(name, [=](double c) { return fresnel_conductor(c, 1.0, eta, k); });
  };
  metal_row("thesis' gold", 0.277, 2.92);
  row("  as printed",
      [](double c) { return mistakes::fresnel_conductor_as_printed(c, 1.0, 0.277, 2.92); });
  metal_row("gold, red", gold.eta.r, gold.k.r);
  metal_row("gold, green", gold.eta.g, gold.k.g);
  metal_row("gold, blue", gold.eta.b, gold.k.b);
  return text;
}

}  // namespace lt
