/// @file
/// The chapter's numbers, as text.
#pragma once

#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "ch04_monte_carlo/densities.hpp"
#include "ch04_monte_carlo/error_bar_plots.hpp"
#include "ch04_monte_carlo/error_plots.hpp"
#include "ch04_monte_carlo/mistakes.hpp"

namespace lt {

/// "3.1392 +- 0.0325": an estimate with its 95 % error bar.
[[nodiscard]] inline std::string with_error(const RunningMean& samples) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4f +- %.4f", samples.mean(),
                standard_errors_95 * samples.standard_error());
  return text;
}

/// A line of a table: a name, and what was found.
[[nodiscard]] inline std::string line(const std::string& name, const std::string& found) {
  return name + std::string(name.size() < 34 ? 34 - name.size() : 1, ' ') + found + '\n';
}

/// The three integrals and pi, each in all ways.
[[nodiscard]] inline std::string integral_table(int n, std::uint64_t seed) {
  std::ostringstream table;
  table << n << " samples each, +- is a 95 % interval\n";
  for (const KnownIntegral& integral : known_integrals()) {
    Pcg32 random(seed);
    table << line(integral.name + ", exactly", std::to_string(integral.exact));
    table << line("  uniform",
                  with_error(estimate_uniform(integral.f, integral.a, integral.b, n, random)));
    table << line("  stratified", std::to_string(estimate_stratified(integral.f, integral.a,
                                                                     integral.b, n, random)));
  }
  const auto square = parabola().f;
  for (const double power : {1.0, 2.0}) {
    Pcg32 random(seed);
    table << line("parabola, p ~ x^" + std::to_string(static_cast<int>(power)),
                  with_error(estimate_importance(square, PowerDensity{power, 2}, n, random)));
  }
  Pcg32 random(seed);
  table << line("pi by darts", with_error(estimate_pi(throw_darts(n, random))));
  return table.str();
}

/// Errors against n, and the slopes.
[[nodiscard]] inline std::string error_table(std::uint64_t seed) {
  const std::vector<NamedEstimator> ways{plain(sine()), stratified(sine()), plain(edge()),
                                         stratified(edge())};
  std::vector<std::vector<ErrorAtN>> columns;
  std::string table = "     n";
  for (const NamedEstimator& way : ways) {
    columns.push_back(measure_error(way.estimate, way.exact, 16, 16384, 200, seed));
    table += std::string(18 - way.name.size(), ' ') + way.name;
  }
  char cell[32];
  for (std::size_t row = 0; row < columns[0].size(); ++row) {
    std::snprintf(cell, sizeof cell, "\n%6d", columns[0][row].n);
    table += cell;
    for (const auto& column : columns) {
      std::snprintf(cell, sizeof cell, "%18.3g", column[row].rms());
      table += cell;
    }
  }
  table += "\n slope";
  for (const auto& column : columns) {
    const PowerLaw law = law_of(column);
    std::snprintf(cell, sizeof cell, "%9.3f +- %.3f", law.slope, law.standard_error);
    table += std::string(18 - std::string(cell).size(), ' ') + cell;
  }
  return table + '\n';
}

/// What goes wrong.
[[nodiscard]] inline std::string mistake_table(int n, std::uint64_t seed) {
  char text[200];
  std::string table = "32 bits to a float     ours         divided by 2^32\n";
  for (const std::uint32_t bits : {0u, 0x80000000u, 0xffffff7fu, 0xffffff80u, 0xffffffffu}) {
    std::snprintf(text, sizeof text, "  0x%08x           %.8f   %.8f\n", bits, unit_float(bits),
                  mistakes::unit_float(bits));
    table += text;
  }
  table += "\nvariance of the same values, moved by\n              exact    Welford    naive\n";
  for (const double offset : {0.0, 1e6, 1e8, 1e9}) {
    const mistakes::Variances found = mistakes::variances_at_offset(offset, seed);
    std::snprintf(text, sizeof text, "  %-10.0e  %.6f %.6f   %.6f\n", offset, found.exact,
                  found.welford, found.naive);
    table += text;
  }
  const KnownIntegral x_squared = parabola();
  Pcg32 random(seed);
  table += "\n" + line("x^2 from 0 to 2, exactly", std::to_string(x_squared.exact)) +
           line("  p = x/2, as printed", with_error(mistakes::estimate_importance(
                                             x_squared.f, PowerDensity{1, 2}, 0, 2, n, random)));
  Pcg32 in_order(seed);
  Pcg32 in_arguments(seed);
  const vec2 right = in_order.next_vec2();
  const vec2 drawn = mistakes::next_vec2(in_arguments);
  table += line("two draws in one argument list", drawn == right ? "x first" : "y first");
  return table;
}

}  // namespace lt
