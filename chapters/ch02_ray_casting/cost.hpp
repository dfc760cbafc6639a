/// @file
/// What a search costs, and how that grows with the number of objects.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "ch02_ray_casting/mistakes.hpp"
#include "common/plot.hpp"

namespace lt {

/// Time per ray for a scene of so many spheres.
struct Cost {
  double spheres;
  double nanoseconds;
};

/// Two ways of searching: every object once, and every object against every other.
struct Costs {
  std::vector<Cost> once;
  std::vector<Cost> pairs;
};

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

/// Spheres of radius 1 m, scattered over a cube of 100 m around the origin.
[[nodiscard]] inline Scene scattered_spheres(int count) {
  std::mt19937 bits(1);  // chapter 4 looks into such boxes
  const auto coordinate = [&] { return 100.0f * (static_cast<float>(bits()) * 0x1p-32f - 0.5f); };
  Scene scene;
  for (int i = 0; i < count; ++i) {
    const float x = coordinate();
    const float y = coordinate();
    const float z = coordinate();
    scene.spheres.push_back({{x, y, z}, 1.0f});
  }
  return scene;
}

/// Unit directions, evenly spread over the sphere (a Fibonacci lattice).
[[nodiscard]] inline std::vector<vec3> fan(int count) {
  std::vector<vec3> directions;
  for (int i = 0; i < count; ++i) {
    const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(count);
    const float radius = std::sqrt(1.0f - y * y);
    const float angle = 2.3999632f * static_cast<float>(i);
    directions.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
  }
  return directions;
}

// [time-per-ray]
/// Processor time of one `search(ray)`, nanoseconds: the best of five runs, since whatever else the
/// machine does can only add.
template <class Search>
[[nodiscard]] double time_per_ray(int rays, const Search& search) {
  static const std::vector<vec3> directions = fan(4096);
  double best = infinity;
  for (int run = 0; run < 5; ++run) {
    double sum = 0;  // asked for below, so that no compiler leaves the work out
    const std::clock_t start = std::clock();
    for (int i = 0; i < rays; ++i)
      if (const auto hit = search(Ray{vec3(0.0f), directions[i % 4096]})) sum += hit->t;
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (sum >= 0) best = std::min(best, 1e9 * seconds / rays);
  }
  return best;
}
// [time-per-ray]

/// Measures on this machine; takes a few seconds.
[[nodiscard]] inline Costs measure_costs() {
  Costs costs;
  for (int n = 1; n <= 1024; n *= 2) {
    const Scene scene = scattered_spheres(n);
    costs.once.push_back({static_cast<double>(n),
                          time_per_ray(16'000'000 / (n + 8),
                                       [&](const Ray& ray) { return closest_hit(scene, ray); })});
    if (n > 256) continue;
    costs.pairs.push_back(
        {static_cast<double>(n), time_per_ray(8'000'000 / (n * n + 8), [&](const Ray& ray) {
           return mistakes::closest_hit(scene, ray);
         })});
  }
  return costs;
}

/// The measured times as text, in the form that stored_costs() wants.
[[nodiscard]] inline std::string table(const Costs& costs) {
  std::string text;
  for (const auto& list : {costs.once, costs.pairs}) {
    for (const Cost& cost : list) {
      char entry[64];
      std::snprintf(entry, sizeof entry, "{%.0f, %.1f}, ", cost.spheres, cost.nanoseconds);
      text += entry;
    }
    text += '\n';
  }
  return text;
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
  Series points{"", {}, {}, false, true};
  Series line{label, {}, {}};
  for (const Cost& cost : costs) {
    points.x.push_back(cost.spheres);
    points.y.push_back(cost.nanoseconds);
    line.x.push_back(cost.spheres);
    line.y.push_back(law.start + law.slope * std::pow(cost.spheres, power));
  }
  plot.series.push_back(points);
  plot.series.push_back(line);
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
