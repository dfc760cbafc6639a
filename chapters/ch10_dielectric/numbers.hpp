/// @file
/// Albedos, the price of the choice, and times, as text.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "ch07_fresnel/cost.hpp"
#include "ch10_dielectric/choice_price.hpp"
#include "ch10_dielectric/coat_tables.hpp"
#include "ch10_dielectric/total_albedo.hpp"

namespace lt {

inline constexpr float table_alphas[] = {0.0f, 0.05f, 0.1f, 0.3f, 0.6f, 1.0f};
inline constexpr float table_cosines[] = {1.0f, 0.8f, 0.5f, 0.3f, 0.2f, 0.1f, 0.02f};

// [totals-table]
/// White bodies under a coat of index 1.5: what comes back of 1.
/// @param base   thesis, reciprocal or conserving
/// @param steps  of the quadrature; 400 give four digits
[[nodiscard]] inline std::string totals_table(const std::string& base, int steps) {
  std::string text = "cosine       smooth  a 0.05     0.1     0.3     0.6       1\n";
  for (const float mu : table_cosines) {
    char cell[40];
    std::snprintf(cell, sizeof cell, "%-6.2f     ", mu);
    text += cell;
    for (const float alpha : table_alphas) {
      std::snprintf(cell, sizeof cell, " %7.4f", white_total(base, alpha, mu, steps));
      text += cell;
    }
    text += '\n';
  }
  return text;
}
// [totals-table]

/// Mean and variance of the grey coat's weight for several probabilities, from four angles.
[[nodiscard]] inline std::string choice_table(int steps) {
  std::string text = "cosine  probability      mean   variance\n";
  const auto row = [&](float mu, const char* name, const auto& choice) {
    const auto bsdf = grey_coated(0.1f, choice);
    const auto [mean, variance] = weight_moments(bsdf, at_cosine(mu), steps);
    char line[80];
    std::snprintf(line, sizeof line, "%-6.2f  %5.3f %-8s %6.4f   %8.5f\n", mu,
                  bsdf.coat_probability(at_cosine(mu)), name, mean, variance);
    text += line;
  };
  for (const float mu : {1.0f, 0.5f, 0.3f, 0.1f}) {
    for (const float p : {0.1f, 0.5f, 0.9f})
      row(mu, "fixed", FixedChoice{p});
    row(mu, "by share", ByShare{});
  }
  return text;
}

/// Nanoseconds of each step, as text.
/// @param rounds  of each measurement; 500 take some seconds in all
[[nodiscard]] inline std::string coat_cost_table(int rounds) {
  const CostInputs inputs;
  std::string text = costs_head;
  const auto row = [&](const char* name, const auto& bsdf) {
    text += costs_row(name, bsdf, inputs, rounds);
  };
  const CoatFresnel fresnel{1.5f};
  const Coat<> coat{{0.6f}, fresnel};
  const SpecularAlbedo table(0.6f, 1.5f);
  const Rgb grey(0.5f);
  row("matt", CosineLambert{grey});
  row("coat alone", coat);
  row("over thesis' base", CoatedDiffuse<ThesisBase>{coat, {grey, fresnel}});
  row("over reciprocal base", CoatedDiffuse<ReciprocalBase>{coat, {grey, fresnel}});
  row("over conserving base", CoatedDiffuse<ConservingBase>{coat, {grey, 1.0f, table}});
  row("polished, reciprocal", PolishedDiffuse<ReciprocalBase>{fresnel, {grey, fresnel}});
  return text;
}

}  // namespace lt
