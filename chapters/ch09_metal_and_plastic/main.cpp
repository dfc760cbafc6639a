/// @file
/// Chapter 9's program: metal and plastic, sampled where they reflect.

#include <iostream>

#include "ch09_metal_and_plastic/program.hpp"
#include "common/interrupt.hpp"

namespace {

struct Options {
  lt::RenderOptions picture{450, 360, 64, 1, 0, {}};
  lt::RoughViewOptions show;
  std::string plot = "none";
  std::string table = "none";
};

bool parse(Options& options, int argc, char** argv) {
  lt::RoughViewOptions& show = options.show;
  lt::CommandLine line("ch09_metal_and_plastic", "Metal and plastic, sampled where they reflect.");
  line.add_choice("--view", show.view,
                  {"room", "gold", "green", "spheres", "furnace", "floor", "pair"},
                  "the room or a window of it, seven balls, or a metal floor");
  line.add_choice("--camera", show.camera, {"far", "near"}, "where to stand in the room");
  line.add_choice("--material", show.material, {"gold", "green", "white"}, "of balls or floor");
  line.add_choice("--normals", show.normals, {"visible", "all"}, "how facets are chosen");
  line.add_choice(
      "--wrong", show.wrong,
      {"none", "jacobian", "cosine", "redraw", "twice", "fresnel", "angles", "absolute"},
      "make a mistake that the text shows");
  line.add_float("--roughness", show.roughness, 0, 1, "of the metal floor");
  line.add_int("--all-spp", show.all_spp, 0, 1'000'000, "--spp of a pair's left half; 0: as --spp");
  line.add_int("--depth", show.depth, 0, 1000, "how often light may be scattered");
  line.add_int("--texels", show.texels, 16, 4096, "side of the walls' textures");
  line.add_choice("--plot", options.plot, {"none", "weights", "facets", "noise", "chi-square"},
                  "draw a plot instead (SVG)");
  line.add_choice("--table", options.table, {"none", "weights", "efficiency", "cost"},
                  "print numbers instead");
  line.only_for("--camera", "--view", {"room"});
  line.only_for("--material", "--view", {"spheres", "floor", "pair"});
  line.only_for("--roughness", "--view", {"floor", "pair"});
  for (const char* name : {"--normals", "--wrong"})
    line.only_for(name, "--view", {"room", "gold", "green", "spheres", "furnace", "floor"});
  line.only_for("--normals", "--wrong", {"none"});
  line.only_for("--all-spp", "--view", {"pair"});
  line.only_for("--texels", "--view", {"room", "gold", "green"});
  for (const char* name : {"--view", "--normals", "--wrong"})
    for (const char* instead : {"--plot", "--table"})
      line.only_for(name, instead, {"none"});
  lt::add_picture_options(line, options.picture);
  lt::add_sampling_options(line, options.picture);
  return line.parse(argc, argv);
}

void run(const Options& options, const std::atomic<bool>& cancel) {
  const auto& [picture, show, plot, table] = options;
  if (table != "none") {
    std::cout << lt::sampler_table_named(table, show, picture);
    return;
  }
  const std::filesystem::path out = lt::output_path(picture, show.view, plot);
  if (plot != "none")
    lt::write_sampler_plot(plot, picture.seed, out);
  else
    lt::write_rough_view(show, picture, out, cancel);
  lt::print_outcome(out, cancel, true);
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_interruptible_program("ch09_metal_and_plastic", [&](const auto& cancel) {
    Options options;
    if (parse(options, argc, argv)) run(options, cancel);
  });
}
