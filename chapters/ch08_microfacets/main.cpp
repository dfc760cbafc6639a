/// @file
/// Chapter 8's program: rough surfaces as curves, as a row of balls, and in the room.

#include <iostream>

#include "ch08_microfacets/microfacet_tables.hpp"
#include "ch08_microfacets/microfacet_views.hpp"
#include "common/interrupt.hpp"

namespace {

struct Options {
  lt::RenderOptions picture{700, 110, 64, 1, 0, {}};
  lt::MicrofacetViewOptions show;
  std::string plot = "none";
  std::string table = "none";
};

bool parse(Options& options, int argc, char** argv) {
  lt::MicrofacetViewOptions& show = options.show;
  lt::CommandLine line("ch08_microfacets", "Rough surfaces: balls, lobes and the room.");
  line.add_choice("--view", show.view, {"spheres", "furnace", "room"},
                  "seven balls under one lamp or an even sky, or the room");
  line.add_choice("--material", show.material, {"gold", "glass", "white"}, "of the balls' facets");
  line.add_choice("--masking", show.brdf.masking, {"correlated", "separable"}, "which G2");
  line.add_choice("--wrong", show.brdf.wrong,
                  {"none", "squared", "half", "masking", "four", "printed"},
                  "make a mistake that the text shows");
  line.add_float("--roughness", show.roughness, 0, 1, "of the room's metal ball");
  line.add_choice("--camera", show.camera, {"far", "near"}, "where to stand in the room");
  line.add_int("--depth", show.depth, 0, 1000, "how often light may be scattered in the room");
  line.add_int("--texels", show.texels, 16, 4096, "side of the room's textures");
  line.add_choice("--plot", options.plot,
                  {"none", "lobes-0", "lobes-45", "lobes-75", "d", "g1", "g2", "energy", "printed"},
                  "draw curves instead (SVG)");
  line.add_choice("--table", options.table, {"none", "energy", "cost"}, "print numbers instead");
  line.only_for("--material", "--view", {"spheres"});
  line.only_for("--masking", "--wrong", {"none"});
  for (const char* name : {"--roughness", "--camera", "--depth", "--texels"})
    line.only_for(name, "--view", {"room"});
  for (const char* name : {"--masking", "--wrong"}) {
    line.only_for(name, "--view", {"spheres", "furnace"});
    line.only_for(name, "--plot", {"none", "lobes-0", "lobes-45", "lobes-75"});
    line.only_for(name, "--table", {"none", "energy"});
  }
  for (const char* name : {"--view", "--material"}) {
    line.only_for(name, "--plot", {"none"});
    line.only_for(name, "--table", {"none"});
  }
  lt::add_picture_options(line, options.picture);
  lt::add_sampling_options(line, options.picture);
  options.picture.width = options.picture.height = 0;  // none yet; --help names the row's
  const bool is_wanted = line.parse(argc, argv);
  lt::choose_size(show.view, options.picture);
  return is_wanted;
}

void run(const Options& options, const std::atomic<bool>& cancel) {
  const auto& [picture, show, plot, table] = options;
  if (table == "energy") return void(std::cout << lt::energy_table(show.brdf, 1000));
  if (table == "cost") return void(std::cout << lt::microfacet_cost_table(500));
  const std::filesystem::path out = lt::output_path(picture, show.view, plot);
  if (plot != "none")
    lt::write_microfacet_plot(plot, show, out);
  else
    lt::write_microfacet_view(show, picture, out, cancel);
  lt::print_outcome(out, cancel, true);
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_interruptible_program("ch08_microfacets", [&](const auto& cancel) {
    Options options;
    if (parse(options, argc, argv)) run(options, cancel);
  });
}
