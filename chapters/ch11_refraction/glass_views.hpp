/// @file
/// The pictures that the program offers, by name.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ch07_fresnel/views.hpp"
#include "ch11_refraction/glass_scenes.hpp"
#include "ch11_refraction/media.hpp"
#include "ch11_refraction/mistakes.hpp"

namespace lt {

/// What to show.
struct GlassViewOptions {
  std::string view = "room";   ///< room, caustic, sphere; alphas, indices, colours; spheres,
                               ///< furnace, lamp
  std::string camera = "far";  ///< far or near, for the room
  std::string wrong = "none";  ///< a mistake that the text shows
  float ior = 0.0f;            ///< of the glass; 0: the room's 1.04, elsewhere 1.5
  float roughness = 0.002f;    ///< of the clear sphere, 0 to 1
  float colour = 1.0f;         ///< factor on the clear sphere's attenuation, >= 0
  int depth = 12;              ///< scattering events at most, >= 0
  int texels = 256;            ///< side of the walls' textures
};

/// True for the strips: the clear sphere four times with one thing changed.
[[nodiscard]] inline bool is_strip(const GlassViewOptions& show) {
  return show.view == "alphas" || show.view == "indices" || show.view == "colours";
}

/// True for the balls under a sky.
[[nodiscard]] inline bool is_in_studio(const GlassViewOptions& show) {
  return show.view == "spheres" || show.view == "furnace" || show.view == "lamp";
}

/// The index that is asked for, or the view's own.
[[nodiscard]] inline float index_of(const GlassViewOptions& show) {
  if (show.ior > 0.0f) return show.ior;
  return show.view == "room" ? ClearSphere{}.ior : 1.5f;
}

[[nodiscard]] inline TexturedScene room_for(const GlassViewOptions& show) {
  return complete_room(show.texels, {index_of(show), show.roughness, show.colour});
}

[[nodiscard]] inline Studio glass_studio(const GlassViewOptions& show) {
  if (show.view == "lamp") return lamp_in_glass(index_of(show));
  return glass_row(index_of(show), show.view == "furnace" ? even_sky(Rgb(0.5f)) : Sky{});
}

[[nodiscard]] inline Camera glass_view_camera(const GlassViewOptions& show) {
  if (show.view == "caustic") return caustic_camera();
  if (show.view == "lamp") return lamp_camera();
  if (is_in_studio(show)) return row_camera();
  if (show.view != "room") return glass_camera();
  return camera_named(show.camera);
}

// [with-glass]
/// Calls use(bsdf_at) with what `show` asks for, known when the program is compiled.
template <class Use>
[[nodiscard]] AnyEstimator with_glass_of(const GlassViewOptions& show, const Use& use) {
  namespace m = mistakes;
  if (show.wrong == "printed") return use(m::RoughGlassWith<m::PrintedEleven>{});
  if (show.wrong == "twice") return use(m::RoughGlassWith<m::FresnelTwice>{});
  if (show.wrong == "root") return use(m::RoughGlassWith<m::PrintedSixteen>{});
  if (show.wrong == "weight") return use(m::RoughGlassWith<m::PrintedSeventeen>{});
  if (show.wrong == "scale") return use(m::RoughGlassWith<m::UnscaledGlass>{});
  if (show.wrong == "glow") return use(m::RoughGlassWith<m::GlowingGlass>{});
  if (show.wrong == "sides") return use(m::RoughGlassWith<m::AlwaysFromAir>{});
  return use([](const Surface& s) { return complete_bsdf_at(s); });
}
// [with-glass]

// [media-estimator]
/// @param room  must outlive what is returned
[[nodiscard]] inline AnyEstimator estimator_in(const TexturedScene& room,
                                               const GlassViewOptions& show) {
  return with_glass_of(show, [&](const auto& bsdf_at) -> AnyEstimator {
    return
        [packed = PackedScene(room), bsdf_at, depth = show.depth](const Ray& ray, Pcg32& random) {
          return radiance_through_media(packed, bsdf_at, ray, depth, random);
        };
  });
}
/// @param studio  must outlive what is returned
[[nodiscard]] inline AnyEstimator estimator_in(const Studio& studio, const GlassViewOptions& show) {
  return with_glass_of(show, [&](const auto& bsdf_at) -> AnyEstimator {
    return [&studio, bsdf_at, depth = show.depth](const Ray& ray, Pcg32& random) {
      return radiance_through_media(studio, bsdf_at, ray, depth, random);
    };
  });
}
// [media-estimator]

/// Calls use(camera, estimate) with what the view shows; what `use` keeps must not outlive it.
template <class Use>
void with_view(const GlassViewOptions& show, const Use& use) {
  if (is_in_studio(show)) {
    const Studio studio = glass_studio(show);
    use(glass_view_camera(show), estimator_in(studio, show));
  } else {
    const TexturedScene room = room_for(show);
    use(glass_view_camera(show), estimator_in(room, show));
  }
}

// [glass-panels]
/// The panels of a strip.
[[nodiscard]] inline std::vector<GlassViewOptions> panels_of(const GlassViewOptions& show) {
  std::vector<GlassViewOptions> panels(4, show);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (show.view == "alphas") panels[i].roughness = std::array{0.002f, 0.05f, 0.2f, 0.5f}[i];
    if (show.view == "indices") panels[i].ior = std::array{1.04f, 1.2f, 1.5f, 2.0f}[i];
    if (show.view == "colours") panels[i].colour = std::array{0.0f, 1.0f, 4.0f, 16.0f}[i];
  }
  return panels;
}
// [glass-panels]

/// A view in one go.
/// @param range  seed, threads, tiles and samples
[[nodiscard]] inline Image glass_picture(const GlassViewOptions& show, ivec2 size,
                                         const SampleRange& range, const std::atomic<bool>& cancel,
                                         Progress* progress = nullptr) {
  Film film(size.x, size.y);
  with_view(show, [&](const Camera& camera, const AnyEstimator& estimate) {
    render(film, camera, estimate, range, cancel, progress);
  });
  require_good_samples(film);
  return developed(film);
}

[[nodiscard]] inline Image glass_strip(const GlassViewOptions& show, int width, int height,
                                       const SampleRange& range, const std::atomic<bool>& cancel) {
  const std::vector<GlassViewOptions> panels = panels_of(show);
  return panel_strip(
      show.view, static_cast<int>(panels.size()), width, height, range.last,
      [&](std::size_t i, int panel_width, Progress& progress) {
        return glass_picture(panels[i], {panel_width, height}, range, cancel, &progress);
      });
}

}  // namespace lt
