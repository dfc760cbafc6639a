/// @file
/// The pictures that the program offers, by name.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ch07_fresnel/views.hpp"
#include "ch09_metal_and_plastic/studio.hpp"
#include "ch10_dielectric/coat_tables.hpp"
#include "ch10_dielectric/mistakes.hpp"

namespace lt {

/// What to show.
struct DielectricViewOptions {
  std::string view = "room";        ///< room, floors, spheres or furnace
  std::string base = "reciprocal";  ///< thesis, reciprocal or conserving
  std::string wrong = "none";       ///< a mistake: none, base, density or divide
  std::string camera = "far";       ///< far or near, for the room
  float roughness = 0.6f;           ///< of the room's floor, 0 to 1
  int depth = 8;                    ///< scattering events at most, >= 0
  int texels = 256;                 ///< side of the walls' textures
};

// [coated-room]
/// The three-sphere room with chapter 7's glass.
/// @param roughness  of the floor; the thesis has 0.6
[[nodiscard]] inline TexturedScene coated_room(int texels, float roughness) {
  TexturedScene scene = smooth_room(texels, 1.5f);
  scene.looks[room::floor].material.roughness = roughness;
  return scene;
}

/// Down onto the floor in front of the clear sphere, where a polished one would mirror the lamp.
[[nodiscard]] inline Camera floor_camera() {
  Camera camera = look_at({0.9f, 1.5f, -0.9f}, {1.1f, 0.05f, 0.2f});
  camera.field_of_view = radians(42.0f);
  return camera;
}
// [coated-room]

// [coated-row]
/// Chapter 9's studio with dielectrics of index 1.5: a red one under a sky with a lamp; or a white
/// one under an even sky, before which a ball that gives back all light cannot be seen.
[[nodiscard]] inline Studio coated_row(const std::string& view) {
  if (view == "furnace") return row_of({.tint = Rgb(1.0f)}, even_sky(Rgb(0.5f)));
  return row_of({.tint = {0.6f, 0.05f, 0.03f}});
}
// [coated-row]

// [with-scattering]
/// Calls use(bsdf_at) with what `show` asks for, known when the program is compiled.
template <class Use>
[[nodiscard]] AnyEstimator with_scattering(const DielectricViewOptions& show,
                                           const TexturedScene& scene, const Use& use) {
  namespace m = mistakes;
  if (show.wrong == "base") return use(m::with_coat(m::bare_base_of));
  if (show.wrong == "density") return use(m::with_coat(m::density_of_chosen_of));
  if (show.wrong == "divide") return use(m::with_coat(m::not_divided_of));
  if (show.base == "conserving")
    return use(ConservingScattering{std::make_shared<const CoatTables>(scene)});
  if (show.base == "thesis") return use([](const Surface& s) { return thesis_bsdf_at(s); });
  return use([](const Surface& s) { return coated_bsdf_at(s); });
}

/// An estimator in the room or in the studio.
/// @param scene  must outlive what is returned
[[nodiscard]] inline AnyEstimator estimator_in(const TexturedScene& scene,
                                               const DielectricViewOptions& show) {
  return with_scattering(
      show, scene, [&](const auto& bsdf_at) { return estimator_with(scene, bsdf_at, show.depth); });
}
[[nodiscard]] inline AnyEstimator estimator_in(const Studio& studio,
                                               const DielectricViewOptions& show) {
  return with_scattering(show, studio.scene, [&](const auto& bsdf_at) -> AnyEstimator {
    return [&studio, bsdf_at, depth = show.depth](const Ray& ray, Pcg32& random) {
      return radiance_recursive(studio, bsdf_at, ray, depth, random);
    };
  });
}
// [with-scattering]

/// Calls use(camera, estimate) with what the view shows; what `use` keeps must not outlive it.
template <class Use>
void with_view(const DielectricViewOptions& show, const Use& use) {
  if (show.view == "room") {
    const TexturedScene room = coated_room(show.texels, show.roughness);
    use(camera_named(show.camera), estimator_in(room, show));
  } else {
    const Studio studio = coated_row(show.view);
    use(row_camera(), estimator_in(studio, show));
  }
}

/// The strip's floors: without a coat, the thesis', a smoother one, and a polished one.
inline constexpr std::array<float, 4> floor_roughness{0.6f, 0.6f, 0.1f, 0.0f};

/// One floor of the strip.
[[nodiscard]] inline Image floor_picture(const DielectricViewOptions& show, std::size_t number,
                                         ivec2 size, const SampleRange& range,
                                         const std::atomic<bool>& cancel, Progress& progress) {
  TexturedScene scene = coated_room(show.texels, floor_roughness[number]);
  if (number == 0) scene.looks[room::floor].material.specular = 0.0f;
  Film film(size.x, size.y);
  render(film, floor_camera(), estimator_in(scene, show), range, cancel, &progress);
  require_good_samples(film);
  return developed(film);
}

[[nodiscard]] inline Image floors_strip(const DielectricViewOptions& show, int width, int height,
                                        const SampleRange& range, const std::atomic<bool>& cancel) {
  return panel_strip(
      show.view, static_cast<int>(floor_roughness.size()), width, height, range.last,
      [&](std::size_t i, int panel_width, Progress& progress) {
        return floor_picture(show, i, {panel_width, height}, range, cancel, progress);
      });
}

}  // namespace lt
