/// @file
/// What the program does with its options.
#pragma once

#include <filesystem>
#include <string>

#include "ch05_rendering_equation/program.hpp"
#include "ch11_refraction/glass_plots.hpp"
#include "ch11_refraction/glass_tables.hpp"
#include "ch11_refraction/glass_views.hpp"

namespace lt {

/// Says which views, plots and tables use which options; these must have been added.
inline void restrict_glass_options(CommandLine& line) {
  line.only_for("--camera", "--view", {"room"});
  line.only_for("--texels", "--view",
                {"room", "caustic", "sphere", "alphas", "indices", "colours"});
  line.only_for("--ior", "--view",
                {"room", "caustic", "sphere", "alphas", "colours", "spheres", "furnace", "lamp"});
  line.only_for("--roughness", "--view", {"room", "caustic", "sphere", "indices", "colours"});
  line.only_for("--colour", "--view", {"room", "caustic", "sphere", "alphas", "indices"});
  for (const char* name : {"--view", "--wrong", "--depth", "--texels"})
    for (const char* instead : {"--plot", "--table"})
      line.only_for(name, instead, {"none"});
}

/// Writes the picture of a view; that of one scene in passes, so that one can watch.
inline void write_glass_view(const GlassViewOptions& show, const RenderOptions& picture,
                             const std::filesystem::path& out, const std::atomic<bool>& cancel) {
  if (is_strip(show)) {
    const SampleRange range = whole_range_for(picture);
    save_image(out, glass_strip(show, picture.width, picture.height, range, cancel));
    return;
  }
  with_view(show, [&](const Camera& camera, const AnyEstimator& estimate) {
    render_to_file(estimate, camera, picture, out, cancel);
  });
}

/// Draws a plot.
/// @throws InputError  `out` is no .svg
inline void write_glass_plot(const std::string& name, const std::filesystem::path& out) {
  require_plot_path(out);
  write_file_whole(out, to_svg(glass_plot_named(name)));
}

}  // namespace lt
