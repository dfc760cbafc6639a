// The three-sphere room, seen but not yet lit.
#include <cmath>
#include <iostream>

#include "ch01_pixels/image_file.hpp"
#include "ch02_ray_casting/cost_plot.hpp"
#include "ch02_ray_casting/views.hpp"
#include "common/command_line.hpp"
#include "common/files.hpp"

namespace {

struct Options {
  lt::RenderOptions picture;
  std::string view = "normals";
  std::string camera = "far";
  float field_of_view = 72.0f;
  std::string plot = "none";
  bool measure = false;
};

bool parse(Options& options, int argc, char** argv) {
  lt::CommandLine line("ch02_ray_casting", "The three-sphere room, seen but not yet lit.");
  line.add_choice("--view", options.view, lt::view_names(), "what the picture shows");
  line.add_choice("--camera", options.camera, {"near", "far"}, "where you stand in the room");
  line.add_float("--fov", options.field_of_view, 1, 170, "how wide you see, in degrees");
  line.add_choice("--plot", options.plot, {"none", "cost"}, "draw a plot instead (SVG)");
  line.add_flag("--measure", options.measure, "plot this machine's times, not the stored ones");
  line.add_int("--threads", options.picture.threads, 0, 1024, "threads; 0: one for each processor");
  for (const char* of_pictures : {"--view", "--camera", "--fov", "--threads"})
    line.only_for(of_pictures, "--plot", {"none"});
  line.only_for("--measure", "--plot", {"cost"});
  for (const char* of_room : {"--camera", "--fov"})
    line.only_for(of_room, "--view", lt::room_view_names());
  lt::add_picture_options(line, options.picture);
  return line.parse(argc, argv);
}

void write_plot(const Options& options, const std::filesystem::path& out) {
  lt::require_plot_path(out);
  const lt::Costs costs = options.measure ? lt::measure_costs() : lt::stored_costs();
  if (options.measure)
    std::cout << lt::table(costs) << "room: " << std::lround(lt::measure_room()) << " ns a ray\n";
  lt::write_file_whole(out, lt::to_svg(lt::cost_plot(costs)));
}

void write_picture(const Options& options, const std::filesystem::path& out) {
  lt::require_picture_path(out);  // before the work, not after it
  const lt::Stage stage = lt::stage_for(options.view, options.camera, options.field_of_view);
  const auto& [width, height, spp, seed, threads, ignored] = options.picture;

  const lt::Image image =
      lt::draw(stage.scene, stage.camera, lt::view_named(options.view), width, height, threads);
  lt::save_image(out, image);
  if (options.view == "acne" || options.view == "leave")
    std::cout << 100 * lt::share_of(image, lt::self_hit_color)
              << " % of the points hit the surface that they are on\n";
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_program("ch02_ray_casting", [&] {
    Options options;
    if (!parse(options, argc, argv)) return;
    const bool is_plot = options.plot != "none";
    std::filesystem::path out = options.picture.out;
    if (out.empty()) out = is_plot ? options.plot + ".svg" : options.view + ".png";
    is_plot ? write_plot(options, out) : write_picture(options, out);
    std::cout << "wrote " << lt::printable(out.string()) << '\n';
  });
}
