/// @file
/// The matt room with both samplers, in both layouts.
#pragma once

#include <string>

#include "ch05_rendering_equation/views.hpp"
#include "ch06_importance_sampling/mistakes.hpp"
#include "ch06_importance_sampling/packed_scene.hpp"

namespace lt {

/// The room as a list of shapes and packed in blocks. It stays where it is: one points at the
/// other.
struct SampledRoom {
  TexturedScene list;
  PackedScene packed{list};

  /// @param texels  side of the walls' textures
  explicit SampledRoom(int texels) : list(matt_room(texels)) {}
  SampledRoom(const SampledRoom&) = delete;
  SampledRoom& operator=(const SampledRoom&) = delete;
};

/// How to render the room.
struct SampledRoomOptions {
  std::string sampler = "cosine";  ///< uniform or cosine
  std::string wrong = "none";      ///< a mistake that the text shows: none, density, root, both
  std::string layout = "packed";   ///< list or packed
  int depth = 8;                   ///< scattering events at most, >= 0
};

// [estimator-on]
/// The recursion of chapter 5 on a room in the layout that is asked for, with a Bsdf that is known
/// when the program is compiled.
template <auto bsdf_at>
[[nodiscard]] AnyEstimator estimator_on(const SampledRoom& room, const std::string& layout,
                                        int depth) {
  const auto on = [depth](const auto& scene) -> AnyEstimator {
    return [&scene, depth](const Ray& ray, Pcg32& random) {
      constexpr auto scatter = [](const Surface& surface) { return bsdf_at(surface); };
      return radiance_recursive(scene, scatter, ray, depth, random);
    };
  };
  return layout == "list" ? on(room.list) : on(room.packed);
}
// [estimator-on]

/// @param room  must outlive what is returned
[[nodiscard]] inline AnyEstimator estimator_for(const SampledRoom& room,
                                                const SampledRoomOptions& options) {
  const auto& [sampler, wrong, layout, depth] = options;
  const bool is_uniform = sampler == "uniform";
  if (wrong == "density") return estimator_on<mistakes::old_density_at>(room, layout, depth);
  if (wrong == "root") return estimator_on<mistakes::without_root_at>(room, layout, depth);
  if (wrong == "both" && is_uniform)
    return estimator_on<mistakes::both_uniform_asked_evenly_at>(room, layout, depth);
  if (wrong == "both") return estimator_on<mistakes::both_uniform_at>(room, layout, depth);
  if (is_uniform) return estimator_on<uniform_lambert_at>(room, layout, depth);
  return estimator_on<cosine_lambert_at>(room, layout, depth);
}

}  // namespace lt
