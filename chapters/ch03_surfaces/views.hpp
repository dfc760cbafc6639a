/// @file
/// The pictures that the program offers, by name.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "ch02_ray_casting/views.hpp"
#include "ch03_surfaces/exhibits.hpp"
#include "ch03_surfaces/flat_views.hpp"
#include "ch03_surfaces/image_texture.hpp"
#include "ch03_surfaces/mistakes.hpp"
#include "ch03_surfaces/smooth_picture.hpp"
#include "common/error.hpp"

namespace lt {

/// What to show.
struct SurfaceViewOptions {
  std::string view = "room";
  std::string camera = "far";        ///< far, near or wall
  std::string normal_maps = "on";    ///< on or off
  std::string texture_on = "globe";  ///< what wears `texture`: globe or wall
  std::filesystem::path texture;     ///< a picture file; empty: the world map
  float rotate = 0.0f;               ///< the globe, eastwards, degrees
  bool wrong = false;                ///< with the mistake that the text shows
  int texels = 512;                  ///< side of the walls' textures, texels
  int grid = 3;                      ///< grid x grid points in each pixel
  int width = 900;                   ///< pixels
  int height = 720;                  ///< pixels
};

/// Where to stand in the room: the thesis' two places, or close to the bricks, looking along them.
/// @param name  "far", "near" or "wall"
[[nodiscard]] inline Camera room_camera(const std::string& name) {
  if (name == "far") return room_camera_far();
  if (name == "near") return room_camera_near();
  return look_at({2.6f, 2.0f, 2.66f}, {1.45f, 2.06f, 3.0f});
}

[[nodiscard]] inline bool is_room(const SurfaceViewOptions& options) {
  return options.view == "room" || options.view == "uv" || options.view == "normals";
}

/// The scene that the view shows.
/// @throws InputError  the texture cannot be read
[[nodiscard]] inline Exhibit make_exhibit(const SurfaceViewOptions& options) {
  const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
  const float eastward = radians(options.rotate);
  if (options.view == "balls") return brick_balls(4, options.texels, aspect);
  if (options.view == "seam") return seam_and_pole(options.texels, aspect);

  const Texture picture = options.texture.empty() ? Texture() : load_color(options.texture);
  const bool on_globe = picture && options.texture_on == "globe";
  const Texture world =
      on_globe
          ? picture
          : std::make_shared<const Image>(world_map((is_room(options) ? 2 : 4) * options.texels));
  if (!is_room(options)) return globes(options.view == "spin" ? 5 : 1, world, eastward, aspect);

  Exhibit room = room_exhibit(room_camera(options.camera), options.texels, world, eastward);
  if (picture && !on_globe)
    for (std::uint32_t half = room::north_wall; half < room::west_wall; ++half)
      room.scene.looks[half] = {Material{}, picture, {}};
  return room;
}

/// What a ray that hits `surface` brings back.
[[nodiscard]] inline Rgb view_color(const std::string& view, const Exhibit& exhibit,
                                    const Surface& surface, const Ray& ray, Hit hit) {
  if (view == "uv") {  // asked for here, because who wears no texture has none in its Surface
    const vec2 uv = texture_point(exhibit.scene, hit.object, surface.point).uv;
    return as_code(vec3(glm::fract(uv), 0.2f));
  }
  if (view == "normals") return direction_color(surface.frame.normal);
  return lit(exhibit.lamp, surface, ray, hit.t);
}

/// The picture that `options` ask for.
/// @throws InputError  there is no --wrong of this view, or a texture cannot be read
[[nodiscard]] inline Image make_picture(const SurfaceViewOptions& options) {
  const std::string& view = options.view;
  if (options.wrong && view != "room" && view != "balls")
    throw InputError("--wrong is for the views room and balls; leave it out for " + view);
  if (view == "maps") return pattern_sheet(options.texels, options.width, options.height);
  if (view == "filter") return filter_strip(options.width, options.height);

  Exhibit exhibit = make_exhibit(options);
  for (Look& look : exhibit.scene.looks) {
    if (options.normal_maps == "off") look.normals = nullptr;
    if (options.wrong && view == "room" && look.color)
      look.color = mistakes::not_decoded(*look.color);
  }
  const bool is_local = options.wrong && view == "balls";
  const auto look_up = is_local ? mistakes::surface_with_local_normal : surface_at;
  return smooth_picture(
      exhibit.camera, options.width, options.height, options.grid, [&](const Ray& ray) {
        const auto hit = closest_hit(exhibit.scene.shapes, ray);
        if (!hit) return Rgb(0.0f);
        return view_color(view, exhibit, look_up(exhibit.scene, ray, *hit), ray, *hit);
      });
}

}  // namespace lt
