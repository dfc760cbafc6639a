/// @file
/// The pictures that the program offers, by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ch05_rendering_equation/program.hpp"
#include "ch07_fresnel/views.hpp"
#include "ch08_microfacets/ball_row.hpp"
#include "ch08_microfacets/microfacet_plots.hpp"
#include "ch08_microfacets/rough_room.hpp"

namespace lt {

/// What to show.
struct MicrofacetViewOptions {
  std::string view = "spheres";   ///< spheres, furnace or room
  std::string material = "gold";  ///< of the spheres: gold, glass or white
  BrdfOptions brdf;               ///< of spheres and plots
  float roughness = 0.3f;         ///< of the room's metal ball, 0 to 1
  std::string camera = "far";     ///< far or near, for the room
  int depth = 8;                  ///< scattering events at most, for the room, >= 0
  int texels = 256;               ///< side of the walls' textures
};

/// Gives a picture whose sides are 0 the size that suits its view: a row of balls is wide.
/// @param view  as in MicrofacetViewOptions
inline void choose_size(const std::string& view, RenderOptions& picture) {
  if (picture.width == 0) picture.width = view == "room" ? 450 : 700;
  if (picture.height == 0) picture.height = view == "room" ? 360 : 110;
}

/// The BRDFs of the row.
[[nodiscard]] inline std::vector<AnyBrdf> row_brdfs(const MicrofacetViewOptions& show) {
  std::vector<AnyBrdf> brdfs;
  for (const float alpha : row_alphas) {
    const auto with = [&](const auto& fresnel) {
      brdfs.push_back(brdf_named(show.brdf, Ggx{alpha}, fresnel));
    };
    if (show.view == "furnace" || show.material == "white")
      with(PerfectMirror{});
    else if (show.material == "glass")
      with(DielectricFresnel{1.0f, 1.5f});
    else
      with(ConductorFresnel{gold});
  }
  return brdfs;
}

/// Above and behind the viewer, ten times as wide as the sun; as bright as makes the roughest gold
/// ball plain to see.
inline const FarLamp row_lamp{normalize(vec3(0.0f, 1.0f, -1.0f)), radians(5.0f), 8.0f};

// [row-estimator]
/// Estimators of the row's pictures. They keep what they need.
[[nodiscard]] inline AnyEstimator row_estimator(const MicrofacetViewOptions& show) {
  const Scene row = ball_row();
  const std::vector<AnyBrdf> brdfs = row_brdfs(show);
  if (show.view == "spheres")
    return [=](const Ray& ray, Pcg32& random) {
      return lamp_light(row, brdfs, row_lamp, ray, random);
    };
  std::vector<AlbedoTable> albedos;
  for (std::size_t i = 0; i < brdfs.size(); ++i)
    albedos.emplace_back(brdfs[i], row_alphas[i], 150);
  return [=](const Ray& ray, Pcg32& /*random*/) { return sky_light(row, albedos, ray); };
}
// [row-estimator]

/// Writes the picture of a view in passes, so that one can watch.
/// @throws InputError  the furnace as printed: its peaks lie where the quadrature does not look
inline void write_microfacet_view(const MicrofacetViewOptions& show, const RenderOptions& picture,
                                  const std::filesystem::path& out,
                                  const std::atomic<bool>& cancel) {
  if (show.view == "furnace" && show.brdf.wrong == "printed")
    throw InputError("--wrong: printed is seen in --view spheres, and in --plot printed");
  if (show.view != "room") {
    render_to_file(row_estimator(show), row_camera(), picture, out, cancel);
    return;
  }
  const TexturedScene list = rough_room(show.texels, show.roughness);
  const PackedScene room(list);
  const auto estimate = [&](const Ray& ray, Pcg32& random) {
    const auto bsdf_at = [](const Surface& surface) { return rough_metal_at(surface); };
    return radiance_recursive(room, bsdf_at, ray, show.depth, random);
  };
  render_to_file(estimate, camera_named(show.camera), picture, out, cancel);
}

/// Draws a plot: a lobe seen from "lobes-0", "lobes-45" or "lobes-75", or one of
/// microfacet_plot_named().
/// @throws InputError  `out` is no .svg
inline void write_microfacet_plot(const std::string& name, const MicrofacetViewOptions& show,
                                  const std::filesystem::path& out) {
  require_plot_path(out);
  const std::string lobes = "lobes-";
  if (name.starts_with(lobes))
    write_file_whole(out, to_svg(lobe_plot(show.brdf, std::stod(name.substr(lobes.size())))));
  else
    write_file_whole(out, to_svg(microfacet_plot_named(name)));
}

}  // namespace lt
