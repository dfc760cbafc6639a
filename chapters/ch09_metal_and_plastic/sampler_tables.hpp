/// @file
/// What both ways to choose a facet cost and gain, as numbers.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "ch06_importance_sampling/efficiency.hpp"
#include "ch07_fresnel/cost.hpp"
#include "ch09_metal_and_plastic/rough_views.hpp"
#include "ch09_metal_and_plastic/sampler_plots.hpp"

namespace lt {

// [weight-table]
/// Mean, standard deviation and largest of the weights of perfect mirrors at cosine 0.1.
/// @param count  samples of each row
[[nodiscard]] inline std::string weight_table(int count, std::uint64_t seed) {
  std::string text = "cosine 0.1       all normals               visible normals\n";
  text += "alpha     mean  deviation  largest     mean  deviation  largest\n";
  for (const float alpha : {0.05f, 0.1f, 0.3f, 0.6f, 1.0f}) {
    char cell[80];
    std::snprintf(cell, sizeof cell, "%-5g", double{alpha});
    text += cell;
    const auto add = [&](const auto& bsdf) {
      RunningMean mean;
      double largest = 0;
      for (const double weight : weights_of(bsdf, at_cosine(0.1f), count, seed)) {
        mean.add(weight);
        largest = std::max(largest, weight);
      }
      std::snprintf(cell, sizeof cell, "  %7.4f  %9.4f  %7.2f", mean.mean(),
                    std::sqrt(mean.variance()), largest);
      text += cell;
    };
    add(White<AllNormals>{{alpha}, {}});
    add(White<VisibleNormals>{{alpha}, {}});
    text += '\n';
  }
  return text;
}
// [weight-table]

// [rough-efficiency]
/// Variance, time and efficiency of both samplers in several views, as text.
/// @param samples  per pixel
[[nodiscard]] inline std::string rough_efficiency_table(RoughViewOptions show, int samples,
                                                        std::uint64_t seed) {
  std::string text = "view        normals   variance  ns/sample  efficiency\n";
  for (const char* view : {"room", "gold", "green", "spheres", "furnace", "floor"})
    for (const char* normals : {"all", "visible"}) {
      show.view = view;
      show.normals = normals;
      const SampleCost cost = measure_cost(rough_camera(show), rough_estimator(show), 140, 50,
                                           {.last = samples, .seed = seed, .threads = 1});
      char line[120];
      std::snprintf(line, sizeof line, "%-10s  %-8s %9.5f  %9.0f  %10.0f\n", view, normals,
                    cost.variance, 1e9 * cost.seconds, efficiency(cost));
      text += line;
    }
  return text;
}
// [rough-efficiency]

/// Nanoseconds of each step, as text.
/// @param rounds  of each measurement; 500 take two seconds in all
[[nodiscard]] inline std::string rough_cost_table(int rounds) {
  const CostInputs inputs;
  const std::vector<vec3>&wo = inputs.wo, &wi = inputs.wi, &u = inputs.u;
  std::string text;
  const auto row = [&](const std::string& name, const auto& f) {
    text += cost_row(name, nanoseconds(f, rounds));
  };
  const Ggx ggx{0.3f};
  const auto sum = [](vec3 v) { return v.x + v.y + v.z; };  // so that no part is left out
  row("a facet among all",
      [&](std::size_t i) { return sum(AllNormals::sample(ggx, wo[i], u[i])); });
  row("a visible facet",
      [&](std::size_t i) { return sum(VisibleNormals::sample(ggx, wo[i], u[i])); });
  const auto rows_of = [&](const std::string& name, const auto& bsdf) {
    row("sample, " + name, [&](std::size_t i) { return sampled(bsdf, wo[i], u[i]); });
    row("pdf, " + name, [&](std::size_t i) { return bsdf.pdf(wo[i], wi[i]); });
  };
  rows_of("perfect mirrors, all", White<AllNormals>{ggx, {}});
  rows_of("perfect mirrors, visible", White<VisibleNormals>{ggx, {}});
  rows_of("gold, all", RoughReflection<ConductorFresnel, AllNormals>{ggx, {gold}});
  rows_of("gold, visible", RoughReflection<ConductorFresnel>{ggx, {gold}});
  rows_of("plastic, visible", PlasticReflection<>{ggx, {{1.0f, 1.5f}, Rgb(0.5f)}});
  return text;
}

}  // namespace lt
