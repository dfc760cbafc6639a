/// @file
/// The pictures that the program offers, by name.
#pragma once

#include <array>
#include <string>

#include "ch05_rendering_equation/views.hpp"
#include "ch06_importance_sampling/packed_scene.hpp"
#include "ch07_fresnel/mistakes.hpp"
#include "ch07_fresnel/smooth_room.hpp"

namespace lt {

/// What to show.
struct SmoothViewOptions {
  std::string view = "room";     ///< room, glass, metal, water, indices or metals
  std::string camera = "far";    ///< far or near, for the room
  std::string metal = "thesis";  ///< what the metal ball is of: thesis, gold, silver or copper
  std::string wrong = "none";    ///< a mistake that the text shows
  float ior = 0.0f;              ///< of the clear sphere or the water; 0: 1.5 or 1.33
  int depth = 12;                ///< scattering events at most, >= 0
  int texels = 256;              ///< side of the walls' textures
};

/// @param name  gold, silver or copper
[[nodiscard]] inline Metal metal_named(const std::string& name) {
  if (name == "silver") return silver;
  return name == "copper" ? copper : gold;
}

/// The scene of a view.
[[nodiscard]] inline TexturedScene smooth_scene(const SmoothViewOptions& show) {
  if (show.view == "water") return flooded_room(show.texels, show.ior > 0 ? show.ior : 1.33f);
  return smooth_room(show.texels, show.ior > 0 ? show.ior : 1.5f);
}

/// Where to look from in a view.
[[nodiscard]] inline Camera smooth_camera(const SmoothViewOptions& show) {
  if (show.view == "water") return diver_camera();
  if (show.view == "glass" || show.view == "indices") return glass_camera();
  if (show.view == "metal" || show.view == "metals") return metal_camera();
  return camera_named(show.camera);
}

// [smooth-estimator]
/// The recursion of chapter 5 on chapter 6's blocks, with what happens at a surface known when the
/// program is compiled.
/// @param bsdf_at  a function object: of a plain function only the address would be known
/// @param scene  must outlive what is returned
template <Scattering Model>
[[nodiscard]] AnyEstimator estimator_with(const TexturedScene& scene, const Model& bsdf_at,
                                          int depth) {
  return [packed = PackedScene(scene), bsdf_at, depth](const Ray& ray, Pcg32& random) {
    return radiance_recursive(packed, bsdf_at, ray, depth, random);
  };
}

/// @param scene  must outlive what is returned
[[nodiscard]] inline AnyEstimator estimator_for(const SmoothViewOptions& show,
                                                const TexturedScene& scene) {
  namespace m = mistakes;
  const auto with_glass = [&](const auto& glass_from) {
    return estimator_with(scene, m::with_glass(glass_from), show.depth);
  };
  if (show.wrong == "sides") return with_glass(m::glass_inside_out_at);
  if (show.wrong == "root")
    return with_glass([](const Surface& s) { return m::GlassWithoutTotalReflection{glass_at(s)}; });
  if (show.wrong == "scale")
    return with_glass([](const Surface& s) { return m::GlassWithoutScale{glass_at(s)}; });
  if (show.wrong == "twice")
    return with_glass([](const Surface& s) { return m::GlassChosenAndWeighted{glass_at(s)}; });
  if (show.wrong == "printed")
    return estimator_with(
        scene, [](const Surface& s) { return m::printed_mirror_at(s); }, show.depth);
  if (show.metal != "thesis")
    return estimator_with(scene, SmoothWithMetal{metal_named(show.metal)}, show.depth);
  return estimator_with(
      scene, [](const Surface& s) { return smooth_bsdf_at(s); }, show.depth);
}
// [smooth-estimator]

/// The panels of a strip: the same window with one thing changed.
[[nodiscard]] inline std::vector<SmoothViewOptions> panels_of(const SmoothViewOptions& show) {
  std::vector<SmoothViewOptions> panels(4, show);
  if (show.view == "indices") {
    const std::array<float, 4> indices{1.04f, 1.33f, 1.5f, 2.42f};
    for (std::size_t i = 0; i < panels.size(); ++i)
      panels[i].ior = indices[i];
  } else {
    const std::array<const char*, 4> metals{"gold", "thesis", "copper", "silver"};
    for (std::size_t i = 0; i < panels.size(); ++i)
      panels[i].metal = metals[i];
  }
  return panels;
}

/// A view in one go.
/// @param range  seed, threads, tiles and samples
[[nodiscard]] inline Image smooth_picture(const SmoothViewOptions& show, int width, int height,
                                          const SampleRange& range, const std::atomic<bool>& cancel,
                                          Progress* progress = nullptr) {
  const TexturedScene scene = smooth_scene(show);
  Film film(width, height);
  render(film, smooth_camera(show), estimator_for(show, scene), range, cancel, progress);
  require_good_samples(film);
  return developed(film);
}

/// Panels side by side, white lines between them.
/// @param title       of the progress bar
/// @param samples     per pixel
/// @param make_panel  make_panel(i, width, progress) is the Image of panel i, 0 to count - 1
template <class MakePanel>
[[nodiscard]] Image panel_strip(const std::string& title, int count, int width, int height,
                                int samples, const MakePanel& make_panel) {
  Progress progress(title, std::int64_t{width - 2 * (count - 1)} * height * samples);
  Image image(width, height, Rgb(1.0f));
  for (int i = 0; i < count; ++i) {
    const int left = width * i / count + (i > 0 ? 2 : 0);
    const int right = width * (i + 1) / count;
    if (left >= right) continue;  // no room for a panel
    paste_at(image, make_panel(static_cast<std::size_t>(i), right - left, progress), left);
  }
  return image;
}

[[nodiscard]] inline Image smooth_strip(const SmoothViewOptions& show, int width, int height,
                                        const SampleRange& range, const std::atomic<bool>& cancel) {
  const std::vector<SmoothViewOptions> panels = panels_of(show);
  return panel_strip(show.view, static_cast<int>(panels.size()), width, height, range.last,
                     [&](std::size_t i, int panel_width, Progress& progress) {
                       return smooth_picture(panels[i], panel_width, height, range, cancel,
                                             &progress);
                     });
}

}  // namespace lt
