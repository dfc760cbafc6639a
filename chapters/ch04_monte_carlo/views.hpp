/// @file
/// The pictures, plots and tables that the program offers, by name.
#pragma once

#include <string>
#include <vector>

#include "ch04_monte_carlo/costs.hpp"
#include "ch04_monte_carlo/density_plots.hpp"
#include "ch04_monte_carlo/dots.hpp"
#include "ch04_monte_carlo/mistake_plots.hpp"
#include "ch04_monte_carlo/photons.hpp"
#include "ch04_monte_carlo/tables.hpp"
#include "common/command_line.hpp"

namespace lt {

[[nodiscard]] inline std::vector<std::string> chance_views() {
  return {"darts", "evening", "strip", "dots"};
}

[[nodiscard]] inline std::vector<std::string> chance_plots() {
  return {"error",       "edges",     "pi",        "intervals", "p-values", "inversion",
          "exponential", "rejection", "tabulated", "thesis",    "offset"};
}

[[nodiscard]] inline std::vector<std::string> stream_names() {
  return {"independent", "same", "diagonal", "neighbours"};
}

/// @param name  one of stream_names()
[[nodiscard]] inline StreamOf stream_named(const std::string& name) {
  if (name == "same") return mistakes::same_stream;
  if (name == "diagonal") return mistakes::diagonal_stream;
  return name == "neighbours" ? mistakes::neighbour_stream : stream_for;
}

/// What is asked of chance.
struct ChanceOptions {
  std::string view = "darts";
  int samples = 2500;  ///< darts, dots, or samples of a plot or a table
  std::string streams = "independent";
  bool is_stratified = false;
  PhotonOptions photons;  ///< size, seed, threads and samples per pixel
};

/// Says which views, plots and tables use which options; these must have been added.
inline void restrict_chance_options(CommandLine& line) {
  for (const char* of_pictures : {"--view", "--streams", "--stratified", "--spp", "--threads"})
    for (const char* instead : {"--plot", "--table"})
      line.only_for(of_pictures, instead, {"none"});
  for (const char* of_files : {"--plot", "--out"})
    line.only_for(of_files, "--table", {"none"});
  line.only_for("--samples", "--plot",
                {"none", "pi", "inversion", "exponential", "rejection", "tabulated"});
  line.only_for("--samples", "--table", {"none", "integrals", "mistakes"});
  line.only_for("--samples", "--view", {"darts", "dots"});
  line.only_for("--seed", "--table", {"none", "integrals", "errors", "mistakes"});
  line.only_for("--stratified", "--view", {"darts", "evening", "strip"});
  line.only_for("--spp", "--view", {"evening"});  // the strip has its own
  for (const char* of_photons : {"--streams", "--threads"})
    line.only_for(of_photons, "--view", {"evening", "strip"});
}

/// The darts that `options` ask for.
[[nodiscard]] inline std::vector<vec2> darts_for(const ChanceOptions& options) {
  Pcg32 random(options.photons.seed);
  if (!options.is_stratified) return throw_darts(options.samples, random);
  return throw_stratified_darts(static_cast<int>(std::sqrt(options.samples)), random);
}

/// What the darts say, in words.
[[nodiscard]] inline std::string pi_text(const ChanceOptions& options) {
  const RunningMean samples = estimate_pi(darts_for(options));
  const std::string count = " by " + std::to_string(samples.count()) + " darts";
  if (!options.is_stratified) return with_error(samples) + " (95 %)" + count;
  // Their spread does not tell the error of stratified darts.
  return std::to_string(samples.mean()) + count + ", stratified";
}

/// The picture that `options` ask for.
[[nodiscard]] inline Image make_picture(const ChanceOptions& options) {
  const std::string& view = options.view;
  PhotonOptions photons = options.photons;
  if (view == "darts") return dart_picture(darts_for(options), photons.width, photons.height);
  Pcg32 random(photons.seed);
  if (view == "dots") return dot_picture(photons.width, photons.height, options.samples, random);
  photons.is_strip = view == "strip";
  photons.is_stratified = options.is_stratified;
  photons.stream_of = stream_named(options.streams);
  Progress progress(view, std::int64_t{photons.width} * photons.height);
  return photon_picture(photons, &progress);
}

/// @param name  one of chance_plots()
[[nodiscard]] inline Plot make_plot(const std::string& name, int samples, std::uint64_t seed) {
  Pcg32 random(seed);
  if (name == "error") return error_plot(seed);
  if (name == "edges") return edge_plot(seed);
  if (name == "pi") return pi_plot(samples, random);
  if (name == "intervals") return interval_plot(seed);
  if (name == "p-values") return p_value_plot(seed);
  if (name == "inversion") return inversion_plot(samples, random);
  if (name == "exponential") return exponential_plot(samples, random);
  if (name == "rejection") return rejection_plot(samples, random);
  if (name == "tabulated") return tabulated_plot(samples, random);
  return name == "thesis" ? thesis_plot(seed) : offset_plot(seed);
}

/// @param name  integrals, errors, mistakes or costs
[[nodiscard]] inline std::string make_table(const std::string& name, int samples,
                                            std::uint64_t seed) {
  if (name == "integrals") return integral_table(samples, seed);
  if (name == "costs") return cost_table();
  return name == "errors" ? error_table(seed) : mistake_table(samples, seed);
}

}  // namespace lt
