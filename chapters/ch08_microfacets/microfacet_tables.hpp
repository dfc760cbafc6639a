/// @file
/// Albedos and costs as numbers.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "ch07_fresnel/cost.hpp"
#include "ch08_microfacets/microfacet_plots.hpp"

namespace lt {

// [energy-table]
/// Albedos of perfect mirrors, five alphas by nine cosines.
/// @param options  which masking, which mistake
/// @param steps    of the quadrature; 1000 give four digits
[[nodiscard]] inline std::string energy_table(const BrdfOptions& options, int steps) {
  std::string text = "cosine  alpha 0.05     0.1     0.3     0.6       1\n";
  for (const float mu : {1.0f, 0.9f, 0.7f, 0.5f, 0.3f, 0.2f, 0.1f, 0.05f, 0.02f}) {
    char cell[40];
    std::snprintf(cell, sizeof cell, "%-6.2f     ", mu);
    text += cell;
    for (const float alpha : {0.05f, 0.1f, 0.3f, 0.6f, 1.0f}) {
      std::snprintf(cell, sizeof cell, " %7.4f",
                    white_albedo(options, alpha, at_cosine(mu), steps));
      text += cell;
    }
    text += '\n';
  }
  return text;
}
// [energy-table]

/// Nanoseconds of each step, as text.
/// @param rounds  of each measurement; 500 take two seconds in all
[[nodiscard]] inline std::string microfacet_cost_table(int rounds) {
  const CostInputs inputs;
  const std::vector<vec3>&wo = inputs.wo, &wi = inputs.wi, &u = inputs.u;
  std::string text;
  const auto row = [&](const char* name, const auto& f) {
    text += cost_row(name, nanoseconds(f, rounds));
  };
  const Ggx ggx{0.3f};
  const MicrofacetReflection white{ggx, PerfectMirror{}};
  const MicrofacetReflection<PerfectMirror, g2_separable> separable{ggx, {}};
  const MicrofacetReflection glass{ggx, DielectricFresnel{1.0f, 1.5f}};
  const MicrofacetReflection metal{ggx, ConductorFresnel{gold}};
  row("half vector", [&](std::size_t i) { return half_vector(wo[i], wi[i]).z; });
  row("D", [&](std::size_t i) { return ggx.d(wi[i]); });
  row("G2, correlated", [&](std::size_t i) { return g2_correlated(ggx, wo[i], wi[i]); });
  row("G2, separable", [&](std::size_t i) { return g2_separable(ggx, wo[i], wi[i]); });
  row("eval, perfect mirrors", [&](std::size_t i) { return white.eval(wo[i], wi[i]).g; });
  row("eval, the same, separable", [&](std::size_t i) { return separable.eval(wo[i], wi[i]).g; });
  row("eval, glass", [&](std::size_t i) { return glass.eval(wo[i], wi[i]).g; });
  row("eval, gold", [&](std::size_t i) {
    const Rgb f = metal.eval(wo[i], wi[i]);
    return f.r + f.g + f.b;
  });
  row("sample, gold", [&](std::size_t i) { return sampled(metal, wo[i], u[i]); });
  return text;
}

}  // namespace lt
