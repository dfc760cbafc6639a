/// @file
/// Chapter 7's program: the room with a mirror and clear glass, and Fresnel's equations as curves.

#include <iostream>

#include "ch07_fresnel/cost.hpp"
#include "ch07_fresnel/program.hpp"
#include "ch07_fresnel/tables.hpp"
#include "common/interrupt.hpp"

namespace {

struct Options {
  lt::RenderOptions picture{450, 360, 64, 1, 0, {}};
  lt::SmoothViewOptions show;
  std::string plot = "none";
  std::string table = "none";
};

bool parse(Options& options, int argc, char** argv) {
  lt::SmoothViewOptions& show = options.show;
  lt::CommandLine line("ch07_fresnel", "The room with a mirror and clear glass.");
  line.add_choice("--view", show.view, {"room", "glass", "metal", "water", "indices", "metals"},
                  "the room, a window of it, the room under water, or four balls");
  line.add_choice("--camera", show.camera, {"far", "near"}, "where to stand in the room");
  line.add_choice("--metal", show.metal, {"thesis", "gold", "silver", "copper"},
                  "what the metal ball is made of");
  line.add_float("--ior", show.ior, 0, 10, "index of the glass or the water; 0: 1.5 or 1.33");
  line.add_choice("--wrong", show.wrong, {"none", "sides", "root", "scale", "twice", "printed"},
                  "make a mistake that the text shows");
  line.add_int("--depth", show.depth, 0, 1000, "how often light may be scattered");
  line.add_int("--texels", show.texels, 16, 4096, "side of the walls' textures");
  line.add_choice(
      "--plot", options.plot,
      {"none", "polarised", "outside", "inside", "gold", "silver", "copper", "schlick", "printed"},
      "draw curves instead (SVG)");
  line.add_choice("--table", options.table, {"none", "reflectance", "cost"},
                  "print numbers instead");
  line.only_for("--camera", "--view", {"room"});
  line.only_for("--metal", "--view", {"room", "metal"});
  line.only_for("--metal", "--wrong", {"none"});
  line.only_for("--ior", "--view", {"room", "glass", "metal", "water"});
  line.only_for("--wrong", "--view", {"room", "glass", "metal", "water"});
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
    std::cout << (table == "cost" ? lt::cost_table(500) : lt::reflectance_table());
    return;
  }
  const std::filesystem::path out = lt::output_path(picture, show.view, plot);
  if (plot != "none")
    lt::write_curves(plot, out);
  else
    lt::write_smooth_view(show, picture, out, cancel);
  lt::print_outcome(out, cancel, true);
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_interruptible_program("ch07_fresnel", [&](const auto& cancel) {
    Options options;
    if (parse(options, argc, argv)) run(options, cancel);
  });
}
