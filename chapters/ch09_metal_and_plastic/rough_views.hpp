/// @file
/// The pictures that the program offers, by name.
#pragma once

#include <algorithm>
#include <memory>
#include <string>

#include "ch06_importance_sampling/room_pictures.hpp"
#include "ch07_fresnel/views.hpp"
#include "ch09_metal_and_plastic/mistakes.hpp"
#include "ch09_metal_and_plastic/studio.hpp"

namespace lt {

/// What to show.
struct RoughViewOptions {
  std::string view = "room";        ///< room, gold, green, spheres, furnace, floor or pair
  std::string camera = "far";       ///< far or near, for the room
  std::string material = "gold";    ///< gold, green or white, for spheres and the floor
  std::string normals = "visible";  ///< visible or all: how facets are chosen
  std::string wrong = "none";       ///< a mistake that the text shows
  float roughness = 0.3f;           ///< of the floor, 0 to 1
  int all_spp = 0;   ///< samples per pixel of a pair's half of all normals; 0: as the other
  int depth = 12;    ///< scattering events at most, >= 0
  int texels = 256;  ///< side of the walls' textures
};

/// True for the views of the room.
[[nodiscard]] inline bool shows_room(const RoughViewOptions& show) {
  return show.view == "room" || show.view == "gold" || show.view == "green";
}

// [row-material]
/// A material by name: those of the thesis, or metal that reflects everything.
[[nodiscard]] inline Material material_named(const std::string& name) {
  const TexturedScene room = three_sphere_room_plain();
  if (name == "gold") return room.looks[room::gold_sphere].material;
  if (name == "green") return room.looks[room::green_sphere].material;
  return {.ior = 1.0f, .extinction = 1e4f, .type = MaterialType::metal};
}

[[nodiscard]] inline Studio studio_for(const RoughViewOptions& show) {
  if (show.view == "furnace") return row_of(material_named("white"), even_sky(Rgb(0.5f)));
  Material material = material_named(show.material);
  if (show.view == "spheres") return row_of(material);
  material.roughness = show.roughness;
  return metal_floor(material);
}
// [row-material]

/// Windows onto the thesis' two balls.
[[nodiscard]] inline Camera ball_camera(float x) {
  Camera camera = look_at({1.5f, 1.5f, -2.064f}, {x, 0.45f, 2.1f});
  camera.field_of_view = radians(14.0f);
  return camera;
}

[[nodiscard]] inline Camera rough_camera(const RoughViewOptions& show) {
  if (show.view == "gold") return ball_camera(0.5f);
  if (show.view == "green") return ball_camera(2.5f);
  if (show.view == "floor" || show.view == "pair") return metal_floor_camera();
  if (!shows_room(show)) return row_camera();
  return camera_named(show.camera);
}

// [with-scattering]
/// Calls `f` with what happens at a surface, as a function object: a type of its own for each kind,
/// so that nothing is looked up while the picture is made.
template <class F>
[[nodiscard]] AnyEstimator with_scattering(const RoughViewOptions& show, const F& f) {
  namespace m = mistakes;
  if (show.wrong == "jacobian") return f(m::RoughWith<m::JacobianForgotten>{});
  if (show.wrong == "cosine") return f(m::RoughWith<m::JacobianAtSurface>{});
  if (show.wrong == "redraw") return f(m::RoughWith<m::Redrawn>{});
  if (show.wrong == "twice") return f(m::RoughWith<m::PaidTwice>{});
  if (show.wrong == "fresnel") return f(m::RoughWith<m::FresnelAtSurface>{});
  if (show.wrong == "angles") return f(m::RoughWith<m::AnglesExchanged>{});
  if (show.wrong == "absolute") return f(m::RoughWith<m::AbsoluteValue>{});
  if (show.normals == "all")
    return f([](const Surface& surface) { return rough_bsdf_at<AllNormals>(surface); });
  return f([](const Surface& surface) { return rough_bsdf_at(surface); });
}
// [with-scattering]

/// @param room  must outlive what is returned
[[nodiscard]] inline AnyEstimator room_estimator(const RoughViewOptions& show,
                                                 const TexturedScene& room) {
  return with_scattering(
      show, [&](const auto& bsdf_at) { return estimator_with(room, bsdf_at, show.depth); });
}

[[nodiscard]] inline AnyEstimator studio_estimator(const RoughViewOptions& show) {
  return with_scattering(show, [&](const auto& bsdf_at) -> AnyEstimator {
    return [studio = studio_for(show), bsdf_at, depth = show.depth](const Ray& ray, Pcg32& random) {
      return radiance_recursive(studio, bsdf_at, ray, depth, random);
    };
  });
}

/// The estimator of any view. It keeps what it needs.
[[nodiscard]] inline AnyEstimator rough_estimator(const RoughViewOptions& show) {
  if (!shows_room(show)) return studio_estimator(show);
  const auto room = std::make_shared<const TexturedScene>(smooth_room(show.texels, 1.5f));
  return [room, estimate = room_estimator(show, *room)](const Ray& ray, Pcg32& random) {
    return estimate(ray, random);
  };
}

// [pair]
/// The floor twice: facets chosen among all on the left, among the visible ones on the right.
[[nodiscard]] inline Image normals_pair(RoughViewOptions show, int width, int height,
                                        const SampleRange& range, const std::atomic<bool>& cancel) {
  const int left = std::max(1, width / 2 - 1);  // two columns between them stay white
  const int right = std::max(1, width - left - 2);
  const int all_spp = show.all_spp > 0 ? show.all_spp : range.last;
  Progress progress("pair", std::int64_t{height} * (left * all_spp + right * range.last));
  Image image(width, height, Rgb(1.0f));
  for (const bool all : {true, false}) {
    show.normals = all ? "all" : "visible";
    SampleRange samples = range;
    if (all) samples.last = all_spp;
    Film film(all ? left : right, height);
    render(film, rough_camera(show), rough_estimator(show), samples, cancel, &progress);
    require_good_samples(film);
    paste_at(image, developed(film), all ? 0 : width - film.width());
  }
  return image;
}
// [pair]

}  // namespace lt
