/// @file
/// Chapter 10's program: the room whose walls and floor wear their coats, and what coats do with
/// energy.

#include <iostream>

#include "ch10_dielectric/program.hpp"
#include "common/interrupt.hpp"

namespace {

struct Options {
  lt::RenderOptions picture{450, 360, 64, 1, 0, {}};
  lt::DielectricViewOptions show;
  std::string plot = "none";
  std::string table = "none";
};

bool parse(Options& options, int argc, char** argv) {
  lt::DielectricViewOptions& show = options.show;
  lt::CommandLine line("ch10_dielectric", "Matt bodies under clear coats.");
  line.add_choice("--view", show.view, {"room", "floors", "spheres", "furnace"},
                  "the room, four floors, or seven balls under a sky or an even one");
  line.add_choice("--base", show.base, {"reciprocal", "thesis", "conserving"},
                  "how much light the coat leaves to the body below");
  line.add_choice("--wrong", show.wrong, {"none", "base", "density", "divide"},
                  "make a mistake that the text shows");
  line.add_choice("--camera", show.camera, {"far", "near"}, "where to stand in the room");
  line.add_float("--roughness", show.roughness, 0, 1, "of the room's floor");
  line.add_int("--depth", show.depth, 0, 1000, "how often light may be scattered");
  line.add_int("--texels", show.texels, 16, 4096, "side of the room's textures");
  line.add_choice("--plot", options.plot, {"none", "coat", "printed", "repairs", "choice"},
                  "draw curves instead (SVG)");
  line.add_choice("--table", options.table, {"none", "totals", "choice", "cost"},
                  "print numbers instead");
  line.only_for("--base", "--wrong", {"none"});
  line.only_for("--base", "--plot", {"none"});
  line.only_for("--base", "--table", {"none", "totals"});
  for (const char* name : {"--camera", "--roughness"})
    line.only_for(name, "--view", {"room"});
  line.only_for("--texels", "--view", {"room", "floors"});
  for (const char* name : {"--view", "--wrong", "--depth", "--texels"}) {
    line.only_for(name, "--plot", {"none"});
    line.only_for(name, "--table", {"none"});
  }
  lt::add_picture_options(line, options.picture);
  lt::add_sampling_options(line, options.picture);
  return line.parse(argc, argv);
}

void run(const Options& options, const std::atomic<bool>& cancel) {
  const auto& [picture, show, plot, table] = options;
  if (table != "none") {
    std::cout << lt::coat_table_named(table, show.base);
    return;
  }
  const std::filesystem::path out = lt::output_path(picture, show.view, plot);
  if (plot != "none")
    lt::write_coat_plot(plot, out);
  else
    lt::write_dielectric_view(show, picture, out, cancel);
  lt::print_outcome(out, cancel, true);
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_interruptible_program("ch10_dielectric", [&](const auto& cancel) {
    Options options;
    if (parse(options, argc, argv)) run(options, cancel);
  });
}
