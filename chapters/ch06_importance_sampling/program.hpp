/// @file
/// What the program does with its options.
#pragma once

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>

#include "ch05_rendering_equation/program.hpp"
#include "ch06_importance_sampling/direction_pictures.hpp"
#include "ch06_importance_sampling/plots.hpp"
#include "ch06_importance_sampling/room_pictures.hpp"

namespace lt {

/// What to show.
struct SamplingOptions {
  std::string view = "cosine";  ///< uniform, cosine, pair, gain, directions or bins
  std::string camera = "far";   ///< far, near or close: where to stand in the room
  SampledRoomOptions room;      ///< how to render it; `view` chooses the sampler
  int uniform_spp = 0;          ///< samples per pixel of the uniform half of a pair; 0: as --spp
  int directions = 2000;        ///< directions to draw, or to count
  int texels = 256;             ///< side of the walls' textures
};

/// Says which views, plots and tables use which options; these must have been added.
inline void restrict_sampling_options(CommandLine& line) {
  for (const char* of_pictures :
       {"--view", "--camera", "--sampler", "--uniform-spp", "--directions"})
    for (const char* instead : {"--plot", "--table"})
      line.only_for(of_pictures, instead, {"none"});
  for (const char* of_files : {"--plot", "--out", "--threads"})
    line.only_for(of_files, "--table", {"none"});
  line.only_for("--spp", "--plot", {"none"});
  for (const char* of_room : {"--wrong", "--layout", "--depth", "--texels", "--threads"})
    line.only_for(of_room, "--plot", {"none", "noise"});
  for (const char* of_room : {"--camera", "--layout", "--depth", "--texels", "--spp", "--threads"})
    line.only_for(of_room, "--view", {"uniform", "cosine", "pair", "gain"});
  line.only_for("--uniform-spp", "--view", {"pair", "gain"});
  line.only_for("--directions", "--view", {"directions", "bins"});
  line.only_for("--sampler", "--view", {"bins"});
  line.only_for("--sampler", "--wrong", {"none"});  // each mistake is one sampler's
}

/// Counts a sampler's directions; prints what chi-square says of them.
[[nodiscard]] inline Image counted_bins(const SamplingOptions& show, const RenderOptions& picture) {
  const NamedSampler sampler = sampler_named(show.room.sampler, show.room.wrong);
  const DirectionBins bins(24, 48);
  Pcg32 random(picture.seed);
  const SamplerReport report = report_on(sampler, show.directions, bins, random);
  char text[160];
  std::snprintf(text, sizeof text, "%s: chi-square %.1f, %d degrees of freedom, p = %.3g\n",
                sampler.name.c_str(), report.chi_square.statistic,
                report.chi_square.degrees_of_freedom, report.chi_square.p_value);
  std::cout << text;
  return bins_picture(picture.width, picture.height, bins, report);
}

/// The view that `show` asks for, as a picture in one go.
[[nodiscard]] inline Image make_picture(const SamplingOptions& show, const RenderOptions& picture,
                                        const std::atomic<bool>& cancel) {
  const auto& [width, height, spp, seed, threads, ignored] = picture;
  if (show.view == "directions")
    return directions_picture(width, height, show.room.wrong, show.directions, seed);
  if (show.view == "bins") return counted_bins(show, picture);
  const SampledRoom room(show.texels);
  const int uniform_spp = show.uniform_spp > 0 ? show.uniform_spp : spp;
  const PairOptions pair{width, height, uniform_spp, spp, seed, threads};
  const Camera camera = camera_named(show.camera);
  if (show.view == "pair") return pair_picture(room, show.room, camera, pair, cancel);
  return gain_picture(room, show.room, camera, pair);
}

/// Writes the picture of a view; the room in passes, so that one can watch.
inline void write_view(SamplingOptions show, const RenderOptions& picture,
                       const std::filesystem::path& out, const std::atomic<bool>& cancel) {
  if (show.view != "uniform" && show.view != "cosine") {
    save_image(out, make_picture(show, picture, cancel));
    return;
  }
  show.room.sampler = show.view;
  const SampledRoom room(show.texels);
  render_to_file(estimator_for(room, show.room), camera_named(show.camera), picture, out, cancel);
}

/// Draws the plot `name`: heights, noise or chi-square.
/// @throws InputError  `out` is no .svg
inline void write_plot(const std::string& name, const SamplingOptions& show,
                       const RenderOptions& picture, const std::filesystem::path& out,
                       const std::atomic<bool>& cancel) {
  require_plot_path(out);
  const auto measured = [&](const std::string& sampler) {
    const SampledRoom room(show.texels);
    SampledRoomOptions how = show.room;
    how.sampler = sampler;
    return measure_noise(room_camera_near(), estimator_for(room, how), 60, 48, 128,
                         range_for(picture), cancel);
  };
  const auto plot = [&] {
    if (name == "heights") return heights_plot(100'000, picture.seed);
    if (name == "chi-square") return chi_square_plot(picture.seed);
    const auto uniform = measured("uniform");
    const auto cosine = measured("cosine");
    return cancel ? Plot{} : noise_plot(uniform, cosine);  // half a plot is none
  }();
  if (!cancel) write_file_whole(out, to_svg(plot));
}

// [efficiency-table]
/// Variance, time and efficiency of both samplers, as text. Takes some seconds.
[[nodiscard]] inline std::string efficiency_table(const SamplingOptions& show, int samples,
                                                  std::uint64_t seed) {
  const SampledRoom room(show.texels);
  std::string text = "            sampler   variance      ns/sample  efficiency\n";
  for (const std::string camera : {"far", "near", "close"})
    for (const std::string sampler : {"uniform", "cosine"}) {
      SampledRoomOptions how = show.room;
      how.sampler = sampler;
      const SampleCost cost = measure_cost(camera_named(camera), estimator_for(room, how), 90, 72,
                                           {.last = samples, .seed = seed, .threads = 1});
      char line[120];
      std::snprintf(line, sizeof line, "%-10s  %-8s  %8.3f  %13.0f  %10.0f\n", camera.c_str(),
                    sampler.c_str(), cost.variance, 1e9 * cost.seconds, efficiency(cost));
      text += line;
    }
  return text;
}
// [efficiency-table]

}  // namespace lt
