/// @file
/// The rays that paths through the room ask for.
#pragma once

#include <benchmark/benchmark.h>

#include <vector>

#include "ch05_rendering_equation/lit_room.hpp"
#include "ch05_rendering_equation/render.hpp"
#include "ch06_importance_sampling/cosine_lambert.hpp"
#include "ch06_importance_sampling/packed_scene.hpp"

namespace lt::bench {

inline constexpr int depth = 8;
inline constexpr int width = 90, height = 72;

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

/// Path `i` of the far camera's picture: pixel after pixel, `i` modulo their number.
template <Traceable Scene, Scattering Model>
[[nodiscard]] Rgb room_path(const Scene& scene, const Model& bsdf_at, int i) {
  static const Camera camera = room_camera_far();
  const int x = i % width;
  const int y = i / width % height;
  Pcg32 random = stream_for(1, x, y, i / (width * height));
  const vec2 within = random.next_vec2();
  const Ray ray = camera_ray(camera, vec2(x, y) + within, width, height);
  return radiance_recursive(scene, bsdf_at, ray, depth, random);
}

/// The rays of `paths` paths, in their order.
template <Scattering Model>
[[nodiscard]] std::vector<Ray> rays_of(const TexturedScene& scene, const Model& bsdf_at,
                                       int paths) {
  const Recorder recorder{scene, {}};
  for (int i = 0; i < paths; ++i)
    benchmark::DoNotOptimize(room_path(recorder, bsdf_at, i));
  return recorder.rays;
}

}  // namespace lt::bench
