/// @file
/// Chapter 5's program: the three-sphere room, lit for the first time.

#include <iostream>

#include "ch05_rendering_equation/program.hpp"
#include "common/interrupt.hpp"

namespace {

struct Options {
  lt::RenderOptions picture{450, 360, 64, 1, 0, {}};
  lt::LitViewOptions show;
  std::string plot = "none";
};

bool parse(Options& options, int argc, char** argv) {
  lt::LitViewOptions& show = options.show;
  lt::CommandLine line("ch05_rendering_equation", "The three-sphere room, lit for the first time.");
  line.add_choice("--view", show.view, {"room", "strip"}, "the room, or a window at 1..1024 spp");
  line.add_choice("--camera", show.camera, {"far", "near"}, "where to stand in the room");
  line.add_int("--depth", show.depth, 0, 1000, "how often light may be scattered");
  line.add_choice("--wrong", show.wrong, {"none", "cosine", "pi", "offset", "depth"},
                  "make a mistake that the text shows");
  line.add_choice("--plot", options.plot, {"none", "noise", "furnace"}, "draw a plot (SVG)");
  line.add_int("--texels", show.texels, 16, 4096, "side of the walls' textures");
  lt::add_picture_options(line, options.picture);
  lt::add_sampling_options(line, options.picture);
  lt::restrict_lit_options(line);
  return line.parse(argc, argv);
}

void run(const Options& options, const std::atomic<bool>& cancel) {
  const auto& [picture, show, plot] = options;
  const std::filesystem::path out = lt::output_path(picture, show.view, plot);
  if (plot != "none")
    lt::write_plot(plot, show, picture, out, cancel);
  else if (show.view == "room")
    lt::write_room(show, picture, out, cancel);
  else
    lt::write_strip(show, picture, out, cancel);
  lt::print_outcome(out, cancel, plot == "none" || !cancel);  // half a plot is none
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_interruptible_program("ch05_rendering_equation", [&](const auto& cancel) {
    Options options;
    if (parse(options, argc, argv)) run(options, cancel);
  });
}
