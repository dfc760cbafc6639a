/// @file
/// What the program does with its options.
#pragma once

#include <filesystem>
#include <string>

#include "ch05_rendering_equation/program.hpp"
#include "ch07_fresnel/curve_plots.hpp"
#include "ch07_fresnel/views.hpp"

namespace lt {

/// Writes the picture of a view; those of one scene in passes, so that one can watch.
inline void write_smooth_view(const SmoothViewOptions& show, const RenderOptions& picture,
                              const std::filesystem::path& out, const std::atomic<bool>& cancel) {
  if (show.view == "indices" || show.view == "metals") {
    const SampleRange range = whole_range_for(picture);
    save_image(out, smooth_strip(show, picture.width, picture.height, range, cancel));
    return;
  }
  const TexturedScene scene = smooth_scene(show);
  render_to_file(estimator_for(show, scene), smooth_camera(show), picture, out, cancel);
}

/// Draws a plot.
/// @throws InputError  `out` is no .svg
inline void write_curves(const std::string& name, const std::filesystem::path& out) {
  require_plot_path(out);
  write_file_whole(out, to_svg(curve_plot(name)));
}

}  // namespace lt
