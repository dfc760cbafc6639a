/// @file
/// The paths that a picture of the room takes, and the rays that they ask for.
#pragma once

#include <vector>

#include "ch05_rendering_equation/lit_room.hpp"
#include "ch05_rendering_equation/render.hpp"
#include "ch06_importance_sampling/cosine_lambert.hpp"
#include "ch06_importance_sampling/packed_scene.hpp"

namespace lt::bench {

inline constexpr int depth = 8;
inline constexpr int width = 90, height = 72;
inline constexpr int paths = width * height;  ///< one for each pixel

inline constexpr auto uniform = [](const Surface& surface) { return uniform_lambert_at(surface); };
inline constexpr auto cosine = [](const Surface& surface) { return cosine_lambert_at(surface); };

/// A scene that writes down for which rays it was asked.
struct Recorder {
  const TexturedScene& scene;
  mutable std::vector<Ray> rays;
};
[[nodiscard]] inline std::optional<Hit> closest_hit(const Recorder& recorder, const Ray& ray) {
  recorder.rays.push_back(ray);
  return closest_hit(recorder.scene, ray);
}
[[nodiscard]] inline Surface surface_at(const Recorder& recorder, const Ray& ray, Hit hit) {
  return surface_at(recorder.scene, ray, hit);
}
[[nodiscard]] inline Rgb background(const Recorder& recorder, vec3 direction) {
  return background(recorder.scene, direction);
}

/// Takes one sample of each pixel of the far camera's picture, in one thread, as the chapter's
/// program does.
template <Traceable Scene, Scattering Model>
void take_paths(Film& film, const Scene& scene, const Model& bsdf_at, int sample = 0) {
  const std::atomic<bool> never{false};
  const auto estimate = [&](const Ray& ray, Pcg32& random) {
    return radiance_recursive(scene, bsdf_at, ray, depth, random);
  };
  render(film, room_camera_far(), estimate,
         {.first = sample, .last = sample + 1, .seed = 1, .threads = 1}, never);
}

/// The rays of these paths, in their order.
template <Scattering Model>
[[nodiscard]] std::vector<Ray> rays_of(const TexturedScene& scene, const Model& bsdf_at) {
  const Recorder recorder{scene, {}};
  Film film(width, height);
  take_paths(film, recorder, bsdf_at);
  return recorder.rays;
}

}  // namespace lt::bench
