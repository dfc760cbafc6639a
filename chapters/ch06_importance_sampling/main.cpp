/// @file
/// Chapter 6's program: the room with directions that go where light counts, and what that gains.

#include <iostream>

#include "ch06_importance_sampling/program.hpp"
#include "common/interrupt.hpp"

namespace {

struct Options {
  lt::RenderOptions picture{450, 360, 64, 1, 0, {}};
  lt::SamplingOptions show;
  std::string plot = "none";
  std::string table = "none";
};

bool parse(Options& options, int argc, char** argv) {
  lt::SamplingOptions& show = options.show;
  lt::CommandLine line("ch06_importance_sampling", "The room, sampled where light counts.");
  line.add_choice("--view", show.view, {"uniform", "cosine", "pair", "gain", "directions", "bins"},
                  "the room by one sampler or both, or their directions");
  line.add_choice("--camera", show.camera, {"far", "near", "close"}, "where to stand in the room");
  line.add_choice("--sampler", show.room.sampler, {"uniform", "cosine"}, "whose bins to count");
  line.add_choice("--wrong", show.room.wrong, {"none", "density", "root", "both"},
                  "make a mistake that the text shows");
  line.add_choice("--layout", show.room.layout, {"list", "packed"}, "how the shapes lie in memory");
  line.add_int("--depth", show.room.depth, 0, 1000, "how often light may be scattered");
  line.add_int("--uniform-spp", show.uniform_spp, 0, 1'000'000,
               "samples per pixel of a pair's uniform half; 0: as --spp");
  line.add_int("--directions", show.directions, 1, 100'000'000, "directions to draw or count");
  line.add_choice("--plot", options.plot, {"none", "heights", "noise", "chi-square"},
                  "draw a plot instead (SVG)");
  line.add_choice("--table", options.table, {"none", "efficiency"}, "print numbers instead");
  line.add_int("--texels", show.texels, 16, 4096, "side of the walls' textures");
  lt::add_picture_options(line, options.picture);
  lt::add_sampling_options(line, options.picture);
  lt::restrict_sampling_options(line);
  return line.parse(argc, argv);
}

void run(const Options& options, const std::atomic<bool>& cancel) {
  const auto& [picture, show, plot, table] = options;
  if (table != "none") {
    std::cout << lt::efficiency_table(show, picture.samples_per_pixel, picture.seed);
    return;
  }
  const std::filesystem::path out = lt::output_path(picture, show.view, plot);
  if (plot != "none")
    lt::write_plot(plot, show, picture, out, cancel);
  else
    lt::write_view(show, picture, out, cancel);
  lt::print_outcome(out, cancel, plot == "none" || !cancel);  // half a plot is none
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_interruptible_program("ch06_importance_sampling", [&](const auto& cancel) {
    Options options;
    if (parse(options, argc, argv)) run(options, cancel);
  });
}
