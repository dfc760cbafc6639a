/// @file
/// Scenes whose light is known, and a second kind of scene that shares no code with the room.
#pragma once

#include <algorithm>

#include "ch02_ray_casting/three_sphere_room.hpp"
#include "ch05_rendering_equation/radiance.hpp"
#include "ch05_rendering_equation/render.hpp"
#include "ch05_rendering_equation/uniform_lambert.hpp"
#include "common/testkit/statistics.hpp"

namespace lt::testing {

/// A textured scene under a sky that is equally bright everywhere.
struct UnderSky {
  TexturedScene scene;
  Rgb sky;
};

inline std::optional<Hit> closest_hit(const UnderSky& open, const Ray& ray) {
  return closest_hit(open.scene, ray);
}
inline Surface surface_at(const UnderSky& open, const Ray& ray, Hit hit) {
  return surface_at(open.scene, ray, hit);
}
inline Rgb background(const UnderSky& open, vec3 /*direction*/) {
  return open.sky;
}

/// Two endless plates that face each other, at y = 0 and y = 1: a formula, with no shapes and no
/// search. Every path goes to and fro between them.
struct TwoPlates {
  Material lower, upper;
};

inline std::optional<Hit> closest_hit(const TwoPlates&, const Ray& ray) {
  const bool goes_up = ray.direction.y > 0.0f;
  const float t = ((goes_up ? 1.0f : 0.0f) - ray.origin.y) / ray.direction.y;
  if (!(t > 0.0f && t < infinity)) return std::nullopt;
  return Hit{t, goes_up ? 1u : 0u};
}
inline Surface surface_at(const TwoPlates& plates, const Ray& ray, Hit hit) {
  const bool is_upper = hit.object == 1;
  vec3 position = ray.at(hit.t);
  position.y = is_upper ? 1.0f : 0.0f;
  const vec3 normal(0.0f, is_upper ? -1.0f : 1.0f, 0.0f);
  return {{position, normal, 1e-6f},
          true,
          frame_around(normal),
          vec2(0.0f),
          is_upper ? plates.upper : plates.lower};
}
inline Rgb background(const TwoPlates&, vec3 /*direction*/) {
  return Rgb(0.0f);
}

/// Not physics: all light comes from straight ahead, so that the recursion has no noise.
struct StraightUp {
  Rgb albedo;

  [[nodiscard]] Rgb eval(vec3, vec3) const { return albedo; }
  [[nodiscard]] std::optional<BsdfSample> sample(vec3, vec3) const {
    return BsdfSample{{0.0f, 0.0f, 1.0f}, albedo, 1.0f};
  }
  [[nodiscard]] float pdf(vec3, vec3) const { return 1.0f; }
};
inline StraightUp straight_up_at(const Surface& surface) {
  return {surface.material.tint};
}

/// Takes up all light.
struct Soot {
  [[nodiscard]] Rgb eval(vec3, vec3) const { return Rgb(0.0f); }
  [[nodiscard]] std::optional<BsdfSample> sample(vec3, vec3) const { return std::nullopt; }
  [[nodiscard]] float pdf(vec3, vec3) const { return 0.0f; }
};
inline Soot soot_at(const Surface&) {
  return {};
}

inline Material matt(Rgb albedo, Rgb emission = Rgb(0.0f)) {
  return {.emission = emission, .tint = albedo};
}

/// A box of triangles, 3 m wide, all of whose walls face inward.
inline TexturedScene closed_box(const Material& material) {
  Scene box = three_sphere_room();
  box.spheres.clear();
  box.grounds.clear();
  add_wall(box, {0, 0, 3}, {3, 0, 0}, {0, 0, -3});   // floor, y = 0
  add_wall(box, {3, 3, 0}, {-3, 0, 0}, {0, -3, 0});  // south, z = 0
  TexturedScene scene(box);
  for (Look& look : scene.looks)
    look.material = material;
  return scene;
}

/// A sphere of `radius` inside one of 2 m, both around the origin: the inner one shines, the outer
/// one is matt.
inline TexturedScene shell(float radius, float albedo, float radiance) {
  TexturedScene scene(Scene{{{vec3(0.0f), radius}, {vec3(0.0f), 2.0f}}, {}, {}});
  scene.looks[0].material = matt(Rgb(0.0f), Rgb(radiance));
  scene.looks[1].material = matt(Rgb(albedo));
  return scene;
}

/// One channel of many estimates along one ray.
template <RadianceEstimator Estimator>
RunningMean many(const Ray& ray, int count, const Estimator& estimate, int channel = 1) {
  RunningMean mean;
  for (int i = 0; i < count; ++i) {
    Pcg32 random = stream_for(1, 0, 0, i);
    mean.add(estimate(ray, random)[channel]);
  }
  return mean;
}

/// The estimator under test, as the program uses it.
template <Traceable AnyScene>
auto uniform_estimator(const AnyScene& scene, int depth) {
  return [&scene, depth](const Ray& ray, Pcg32& random) {
    return radiance_recursive(scene, uniform_lambert_at, ray, depth, random);
  };
}

}  // namespace lt::testing
