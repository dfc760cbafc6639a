/// @file
/// Chapter 3's program: the room with its textures under a headlight, a globe, and the textures.

#include <iostream>

#include "ch01_pixels/image_file.hpp"
#include "ch03_surfaces/views.hpp"
#include "common/command_line.hpp"
#include "common/files.hpp"

namespace {

struct Options {
  lt::RenderOptions picture;
  lt::SurfaceViewOptions show;
};

bool parse(Options& options, int argc, char** argv) {
  lt::SurfaceViewOptions& show = options.show;
  lt::CommandLine line("ch03_surfaces", "Shows surfaces: texture coordinates, textures, relief.");
  line.add_choice("--view", show.view,
                  {"room", "uv", "normals", "globe", "spin", "balls", "seam", "maps", "filter"},
                  "what to show");
  line.add_choice("--camera", show.camera, {"far", "near", "wall"}, "where to stand in the room");
  line.add_choice("--normal-maps", show.normal_maps, {"on", "off"}, "relief, or flat walls");
  line.add_path("--texture", show.texture, "a picture to put up, PNG or JPEG");
  line.add_choice("--texture-on", show.texture_on, {"globe", "wall"}, "where to put it");
  line.add_float("--rotate", show.rotate, -36000, 36000, "turn the globe eastwards, degrees");
  line.add_flag("--wrong", show.wrong, "make the mistake that the text shows");
  line.add_int("--texels", show.texels, 16, 4096, "side of the walls' textures");
  line.add_int("--grid", show.grid, 1, 16, "points along each side of a pixel");
  line.only_for("--camera", "--view", {"room", "uv", "normals"});
  line.only_for("--normal-maps", "--view", {"room", "normals", "balls", "seam"});
  line.only_for("--texture", "--view", {"room", "globe", "spin"});
  line.only_for("--texture-on", "--view", {"room"});
  line.needs("--texture-on", "--texture");
  line.only_for("--rotate", "--view", {"room", "uv", "globe", "spin"});
  line.only_for("--texels", "--view",
                {"room", "normals", "globe", "spin", "balls", "seam", "maps"});
  line.only_for("--grid", "--view", {"room", "uv", "normals", "globe", "spin", "balls", "seam"});
  lt::add_picture_options(line, options.picture);
  return line.parse(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return lt::run_program("ch03_surfaces", [&] {
    Options options;
    if (!parse(options, argc, argv)) return;
    std::filesystem::path out = options.picture.out;
    if (out.empty()) out = options.show.view + ".png";
    lt::require_picture_path(out);  // before the work, not after it
    options.show.width = options.picture.width;
    options.show.height = options.picture.height;
    lt::save_image(out, lt::make_picture(options.show));
    std::cout << "wrote " << lt::printable(out.string()) << '\n';
  });
}
