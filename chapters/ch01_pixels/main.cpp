/// @file
/// Chapter 1's program: pictures of functions, right and wrong, and the sRGB curve as plots.

#include <iostream>

#include "ch01_pixels/curve_plots.hpp"
#include "ch01_pixels/image_file.hpp"
#include "ch01_pixels/views.hpp"
#include "common/command_line.hpp"
#include "common/files.hpp"

namespace {

struct Options {
  lt::RenderOptions picture;
  std::string view = "evening";
  std::string plot = "none";
  float stops = 0.0f;
  bool wrong = false;
};

bool parse(Options& options, int argc, char** argv) {
  lt::CommandLine line("ch01_pixels", "Paints pictures of functions, in light and in codes.");
  line.add_choice("--view", options.view,
                  {"evening", "checker", "gradient", "glow", "ramp", "galaxy"}, "what to paint");
  line.add_flag("--wrong", options.wrong, "make the mistake that the text shows");
  line.add_float("--stops", options.stops, -16, 16, "exposure: light times 2 to this power");
  line.add_choice("--plot", options.plot, {"none", "curve", "steps"}, "draw a plot instead (SVG)");
  for (const char* of_pictures : {"--view", "--wrong", "--stops"})
    line.only_for(of_pictures, "--plot", {"none"});
  lt::add_picture_options(line, options.picture);
  return line.parse(argc, argv);
}

void write_plot(const Options& options, const std::filesystem::path& out) {
  lt::require_plot_path(out);
  lt::write_file_whole(out,
                       lt::to_svg(options.plot == "curve" ? lt::curve_plot() : lt::step_plot()));
}

void write_picture(const Options& options, const std::filesystem::path& out) {
  lt::require_picture_path(out);  // before the work, not after it
  lt::save_image(out, lt::make_view({options.view, options.picture.width, options.picture.height,
                                     options.stops, options.wrong}));
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_program("ch01_pixels", [&] {
    Options options;
    if (!parse(options, argc, argv)) return;
    const bool is_plot = options.plot != "none";
    std::filesystem::path out = options.picture.out;
    if (out.empty()) out = is_plot ? options.plot + ".svg" : options.view + ".png";
    is_plot ? write_plot(options, out) : write_picture(options, out);
    std::cout << "wrote " << lt::printable(out.string()) << '\n';
  });
}
