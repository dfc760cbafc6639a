/// @file
/// How the cost of a search grows with the number of objects: a law, fitted to measured times.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "ch02_ray_casting/cost.hpp"
#include "common/plot.hpp"

namespace lt {

/// The figure's numbers: the best of four measurements on one core of a 2-core x86-64 server, built
/// with g++ 12.2 -O3. `--measure` takes your machine's.
[[nodiscard]] inline Costs stored_costs() {
  return {{{1, 13.3},
           {2, 14.7},
           {4, 17.8},
           {8, 24.0},
           {16, 40.1},
           {32, 77.4},
           {64, 161.5},
           {128, 312.9},
           {256, 611.8},
           {512, 1209.4},
           {1024, 2397.2}},
          {{1, 13.5},
           {2, 21.1},
           {4, 50.8},
           {8, 177.5},
           {16, 644.7},
           {32, 2460.3},
           {64, 10207.3},
           {128, 39168.0},
           {256, 155549.2}}};
}

/// nanoseconds = start + slope * spheres^power
struct CostLaw {
  double start;
  double slope;
};

// [fit]
/// The law with the least sum of squared *relative* errors: 10 % at 1 sphere counts as much as 10 %
/// at 1000. Two unknowns, two normal equations.
[[nodiscard]] inline CostLaw fit(const std::vector<Cost>& costs, double power) {
  double s11 = 0, s12 = 0, s22 = 0, r1 = 0, r2 = 0;
  for (const Cost& cost : costs) {
    const double u = 1 / cost.nanoseconds;
    const double v = std::pow(cost.spheres, power) / cost.nanoseconds;
    s11 += u * u;
    s12 += u * v;
    s22 += v * v;
    r1 += u;
    r2 += v;
  }
  const double determinant = s11 * s22 - s12 * s12;
  return {(r1 * s22 - r2 * s12) / determinant, (s11 * r2 - s12 * r1) / determinant};
}
// [fit]

/// The measured points, and the fitted law as a line.
inline void add_to_plot(Plot& plot, const std::string& name, const std::vector<Cost>& costs,
                        double power) {
  const CostLaw law = fit(costs, power);
  char label[80];
  std::snprintf(label, sizeof label, "%s: %.0f + %.1f n%s", name.c_str(), law.start, law.slope,
                power == 2 ? "\u00b2" : "");
  Series measured;
  for (const Cost& cost : costs)
    measured.add(cost.spheres, cost.nanoseconds);
  add_dots_and_line(plot, measured, label,
                    [&](double n) { return law.start + law.slope * std::pow(n, power); });
}

[[nodiscard]] inline Plot cost_plot(const Costs& costs) {
  Plot plot;
  plot.title = "The closest of n spheres";
  plot.x_label = "n, spheres in the scene";
  plot.y_label = "nanoseconds per ray";
  plot.log_x = plot.log_y = true;
  plot.description =
      "Dots are measured, lines are fitted, both axes are logarithmic. Asking every sphere once "
      "levels off below ten spheres and then grows in proportion to their number. Asking every "
      "sphere against every other grows with the square: at 256 spheres it takes 250 times as "
      "long.";
  add_to_plot(plot, "each once", costs.once, 1);
  add_to_plot(plot, "each against each", costs.pairs, 2);
  return plot;
}

}  // namespace lt
