/// @file
/// What the program does with its options.
#pragma once

#include <filesystem>
#include <string>

#include "ch05_rendering_equation/program.hpp"
#include "ch09_metal_and_plastic/rough_views.hpp"
#include "ch09_metal_and_plastic/sampler_plots.hpp"
#include "ch09_metal_and_plastic/sampler_tables.hpp"

namespace lt {

/// Writes the picture of a view; those of one estimator in passes, so that one can watch.
inline void write_rough_view(const RoughViewOptions& show, const RenderOptions& picture,
                             const std::filesystem::path& out, const std::atomic<bool>& cancel) {
  if (show.view == "pair") {
    const SampleRange range = whole_range_for(picture);
    save_image(out, normals_pair(show, picture.width, picture.height, range, cancel));
    return;
  }
  render_to_file(rough_estimator(show), rough_camera(show), picture, out, cancel);
}

/// @param name  weights, efficiency or cost
[[nodiscard]] inline std::string sampler_table_named(const std::string& name,
                                                     const RoughViewOptions& show,
                                                     const RenderOptions& picture) {
  if (name == "weights") return weight_table(1'000'000, picture.seed);
  if (name == "cost") return rough_cost_table(500);
  return rough_efficiency_table(show, picture.samples_per_pixel, picture.seed);
}

/// Draws a plot.
/// @throws InputError  `out` is no .svg
inline void write_sampler_plot(const std::string& name, std::uint64_t seed,
                               const std::filesystem::path& out) {
  require_plot_path(out);
  write_file_whole(out, to_svg(sampler_plot_named(name, seed)));
}

}  // namespace lt
