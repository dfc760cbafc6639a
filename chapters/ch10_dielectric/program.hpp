/// @file
/// What the program does with its options.
#pragma once

#include <filesystem>
#include <string>

#include "ch05_rendering_equation/program.hpp"
#include "ch10_dielectric/coat_plots.hpp"
#include "ch10_dielectric/dielectric_views.hpp"
#include "ch10_dielectric/numbers.hpp"

namespace lt {

/// Writes the picture of a view; that of one scene in passes, so that one can watch.
inline void write_dielectric_view(const DielectricViewOptions& show, const RenderOptions& picture,
                                  const std::filesystem::path& out,
                                  const std::atomic<bool>& cancel) {
  if (show.view == "floors") {
    const SampleRange range = whole_range_for(picture);
    save_image(out, floors_strip(show, picture.width, picture.height, range, cancel));
    return;
  }
  with_view(show, [&](const Camera& camera, const AnyEstimator& estimate) {
    render_to_file(estimate, camera, picture, out, cancel);
  });
}

/// Draws a plot.
/// @throws InputError  `out` is no .svg
inline void write_coat_plot(const std::string& name, const std::filesystem::path& out) {
  require_plot_path(out);
  write_file_whole(out, to_svg(coat_plot_named(name)));
}

/// @param name  totals, choice or cost
[[nodiscard]] inline std::string coat_table_named(const std::string& name,
                                                  const std::string& base) {
  if (name == "totals") return totals_table(base, 400);
  return name == "choice" ? choice_table(300) : coat_cost_table(200);
}

}  // namespace lt
