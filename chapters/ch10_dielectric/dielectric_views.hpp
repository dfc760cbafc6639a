/// @file
/// The pictures that the program offers, by name.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ch07_fresnel/views.hpp"
#include "ch08_microfacets/ball_row.hpp"
#include "ch10_dielectric/coat_tables.hpp"
#include "ch10_dielectric/mistakes.hpp"

namespace lt {

/// What to show.
struct DielectricViewOptions {
  std::string view = "room";        ///< room, floors or furnace
  std::string base = "reciprocal";  ///< thesis, reciprocal or conserving
  std::string wrong = "none";       ///< a mistake: none, base, density or divide
  std::string camera = "far";       ///< far or near, for the room
  float roughness = 0.6f;           ///< of the room's floor, 0 to 1
  int depth = 8;                    ///< scattering events at most, for rooms, >= 0
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

// [sky-row]
/// Chapter 8's row of balls, of a white dielectric of index 1.5.
[[nodiscard]] inline TexturedScene white_row() {
  TexturedScene row(ball_row());
  for (std::size_t i = 0; i < row_count; ++i)
    row.looks[i].material = {.roughness = row_alphas[i], .ior = 1.5f};
  return row;
}

/// One estimate under a sky of radiance 1/2 that is the same everywhere. A ball that gives back all
/// light cannot be seen. No light goes from ball to ball.
template <Scattering Model>
[[nodiscard]] Rgb even_sky_light(const TexturedScene& row, const Model& bsdf_at, const Ray& ray,
                                 Pcg32& random) {
  const Rgb sky(0.5f);
  const auto hit = closest_hit(row, ray);
  if (!hit) return sky;
  const Surface surface = surface_at(row, ray, *hit);
  const vec3 wo = surface.frame.to_local(-ray.direction);
  const auto sample = bsdf_at(surface).sample(wo, random.next_vec3());
  return sample ? sample->weight * sky : Rgb(0.0f);
}
// [sky-row]

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

/// @param scene  must outlive what is returned
[[nodiscard]] inline AnyEstimator estimator_for(const DielectricViewOptions& show,
                                                const TexturedScene& scene) {
  return with_scattering(show, scene, [&](const auto& bsdf_at) -> AnyEstimator {
    if (show.view != "furnace") return estimator_with(scene, bsdf_at, show.depth);
    return [&scene, bsdf_at](const Ray& ray, Pcg32& random) {
      return even_sky_light(scene, bsdf_at, ray, random);
    };
  });
}
// [with-scattering]

/// The scene of a view.
[[nodiscard]] inline TexturedScene dielectric_scene(const DielectricViewOptions& show) {
  return show.view == "furnace" ? white_row() : coated_room(show.texels, show.roughness);
}

/// Where to look from in a view.
[[nodiscard]] inline Camera dielectric_camera(const DielectricViewOptions& show) {
  if (show.view == "furnace") return row_camera();
  if (show.view == "floors") return floor_camera();
  return show.camera == "far" ? room_camera_far() : room_camera_near();
}

/// The strip's floors: without a coat, the thesis', a smoother one, and a polished one.
inline constexpr std::array<float, 4> floor_roughness{0.6f, 0.6f, 0.2f, 0.0f};

/// One floor of the strip.
[[nodiscard]] inline Image floor_picture(const DielectricViewOptions& show, std::size_t number,
                                         ivec2 size, const SampleRange& range,
                                         const std::atomic<bool>& cancel, Progress& progress) {
  TexturedScene scene = coated_room(show.texels, floor_roughness[number]);
  if (number == 0) scene.looks[room::floor].material.specular = 0.0f;
  Film film(size.x, size.y);
  render(film, floor_camera(), estimator_for(show, scene), range, cancel, &progress);
  require_good_samples(film);
  return developed(film);
}

/// Four panels side by side, white lines between them.
[[nodiscard]] inline Image floors_strip(const DielectricViewOptions& show, int width, int height,
                                        const SampleRange& range, const std::atomic<bool>& cancel) {
  const int count = static_cast<int>(floor_roughness.size());
  Progress progress(show.view, std::int64_t{width - 2 * (count - 1)} * height * range.last);
  Image image(width, height, Rgb(1.0f));
  for (int i = 0; i < count; ++i) {
    const int left = width * i / count + (i > 0 ? 2 : 0);
    const int right = width * (i + 1) / count;
    if (left >= right) continue;  // no room for a panel
    const Image panel = floor_picture(show, static_cast<std::size_t>(i), {right - left, height},
                                      range, cancel, progress);
    for (int y = 0; y < height; ++y)
      for (int x = left; x < right; ++x)
        image.at(x, y) = panel.at(x - left, y);
  }
  return image;
}

}  // namespace lt
