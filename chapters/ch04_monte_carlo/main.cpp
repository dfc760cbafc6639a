/// @file
/// Chapter 4's program: pi by darts, pictures made by chance, and what can be said of their errors.

#include <iostream>

#include "ch01_pixels/image_file.hpp"
#include "ch04_monte_carlo/views.hpp"
#include "common/command_line.hpp"
#include "common/files.hpp"

namespace {

struct Options {
  lt::RenderOptions picture;
  lt::ChanceOptions chance;
  std::string plot = "none";
  std::string table = "none";
};

std::vector<std::string> none_or(std::vector<std::string> names) {
  names.insert(names.begin(), "none");
  return names;
}

bool parse(Options& options, int argc, char** argv) {
  lt::ChanceOptions& chance = options.chance;
  options.picture.samples_per_pixel = 16;
  lt::CommandLine line("ch04_monte_carlo", "Estimates pi, integrals and pictures by chance.");
  line.add_choice("--view", chance.view, lt::chance_views(), "what the picture shows");
  line.add_choice("--plot", options.plot, none_or(lt::chance_plots()), "draw a plot instead (SVG)");
  line.add_choice("--table", options.table, {"none", "integrals", "errors", "mistakes", "costs"},
                  "print numbers instead");
  line.add_int("--samples", chance.samples, 16, 10'000'000, "darts, dots, samples of a plot");
  line.add_flag("--stratified", chance.is_stratified, "one sample in each of equal parts");
  line.add_choice("--streams", chance.streams, lt::stream_names(),
                  "whose random numbers a pixel gets; all but the first are mistakes");
  lt::add_sampling_options(line, options.picture);
  lt::add_picture_options(line, options.picture);
  lt::restrict_chance_options(line);
  return line.parse(argc, argv);
}

void write_plot(const Options& options, const std::filesystem::path& out) {
  lt::require_plot_path(out);
  lt::write_file_whole(
      out, lt::to_svg(lt::make_plot(options.plot, options.chance.samples, options.picture.seed)));
}

void write_picture(Options& options, const std::filesystem::path& out) {
  lt::require_picture_path(out);  // before the work, not after it
  lt::PhotonOptions& photons = options.chance.photons;
  photons.width = options.picture.width;
  photons.height = options.picture.height;
  photons.samples_per_pixel = options.picture.samples_per_pixel;
  photons.seed = options.picture.seed;
  photons.threads = options.picture.threads;
  lt::save_image(out, lt::make_picture(options.chance));
  if (options.chance.view == "darts") std::cout << "pi: " << lt::pi_text(options.chance) << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_program("ch04_monte_carlo", [&] {
    Options options;
    if (!parse(options, argc, argv)) return;
    if (options.table != "none") {
      std::cout << lt::make_table(options.table, options.chance.samples, options.picture.seed);
      return;
    }
    const bool is_plot = options.plot != "none";
    std::filesystem::path out = options.picture.out;
    if (out.empty()) out = is_plot ? options.plot + ".svg" : options.chance.view + ".png";
    is_plot ? write_plot(options, out) : write_picture(options, out);
    std::cout << "wrote " << lt::printable(out.string()) << '\n';
  });
}
