/// @file
/// Chapter 11's program: the complete three-sphere room, and glass as rough and as coloured as one
/// likes.

#include <iostream>

#include "ch11_refraction/program.hpp"
#include "common/interrupt.hpp"

namespace {

struct Options {
  lt::RenderOptions picture{450, 360, 64, 1, 0, {}};
  lt::GlassViewOptions show;
  std::string plot = "none";
  std::string table = "none";
};

bool parse(Options& options, int argc, char** argv) {
  lt::GlassViewOptions& show = options.show;
  lt::CommandLine line("ch11_refraction", "The complete room, and glass.");
  line.add_choice(
      "--view", show.view,
      {"room", "caustic", "sphere", "alphas", "indices", "colours", "spheres", "furnace", "lamp"},
      "the room or a window of it, four spheres, or balls under a sky");
  line.add_choice("--camera", show.camera, {"far", "near"}, "where to stand in the room");
  line.add_choice("--wrong", show.wrong,
                  {"none", "printed", "twice", "root", "weight", "scale", "sides", "glow"},
                  "make a mistake that the text shows");
  line.add_float("--ior", show.ior, 0, 10, "index of the glass; 0: the room's 1.04, else 1.5");
  line.add_float("--roughness", show.roughness, 0, 1, "of the clear sphere");
  line.add_float("--colour", show.colour, 0, 1000, "factor on the clear sphere's attenuation");
  line.add_int("--depth", show.depth, 0, 1000, "how often light may be scattered");
  line.add_int("--texels", show.texels, 16, 4096, "side of the room's textures");
  line.add_choice("--plot", options.plot, {"none", "through", "root", "energy", "weight", "beer"},
                  "draw curves instead (SVG)");
  line.add_choice("--table", options.table, {"none", "energy", "furnace", "cost"},
                  "print numbers instead");
  lt::restrict_glass_options(line);
  lt::add_picture_options(line, options.picture);
  lt::add_sampling_options(line, options.picture);
  return line.parse(argc, argv);
}

void run(const Options& options, const std::atomic<bool>& cancel) {
  const auto& [picture, show, plot, table] = options;
  if (table != "none") {
    std::cout << lt::glass_table_named(table, picture.seed);
    return;
  }
  const std::filesystem::path out = lt::output_path(picture, show.view, plot);
  if (plot != "none")
    lt::write_glass_plot(plot, out);
  else
    lt::write_glass_view(show, picture, out, cancel);
  lt::print_outcome(out, cancel, true);
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_interruptible_program("ch11_refraction", [&](const auto& cancel) {
    Options options;
    if (parse(options, argc, argv)) run(options, cancel);
  });
}
