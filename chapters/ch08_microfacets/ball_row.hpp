/// @file
/// A row of balls, ever rougher, to look at: under one lamp, or under an even sky.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "ch02_ray_casting/camera.hpp"
#include "ch02_ray_casting/scene.hpp"
#include "ch02_ray_casting/surface_point.hpp"
#include "ch03_surfaces/frame.hpp"
#include "ch04_monte_carlo/pcg32.hpp"
#include "ch08_microfacets/albedo.hpp"
#include "ch08_microfacets/any_brdf.hpp"

namespace lt {

// [row]
inline constexpr float row_alphas[] = {0.02f, 0.05f, 0.1f, 0.2f, 0.4f, 0.7f, 1.0f};
inline constexpr int row_count{std::size(row_alphas)};

/// Seven balls of 1 m, in a row from left to right.
[[nodiscard]] inline Scene ball_row() {
  Scene scene;
  for (int i = 0; i < row_count; ++i)
    scene.spheres.push_back({{2.2f * static_cast<float>(i - row_count / 2), 0.0f, 0.0f}, 1.0f});
  return scene;
}

/// From so far that all balls are seen alike.
[[nodiscard]] inline Camera row_camera() {
  Camera camera = look_at({0.0f, 0.0f, -60.0f}, vec3(0.0f));
  camera.field_of_view = 2.0f * std::atan(7.85f / 60.0f);
  return camera;
}
// [row]

// [far-lamp]
/// A round lamp far away, as the sun is: seen from everywhere in the same direction, equally large.
struct FarLamp {
  vec3 direction;    ///< towards its middle, unit, world
  float angle;       ///< from its middle to its rim, radians
  float irradiance;  ///< on a surface that faces it, W/m^2

  /// A direction to a point of the lamp, all equally likely: chapter 5's hemisphere, cut off at the
  /// rim, so that z goes from 1 down to cos(angle).
  [[nodiscard]] vec3 sample(vec2 u) const {
    const float height = u.x * (1.0f - std::cos(angle));
    const float radius = std::sqrt(height * (2.0f - height));
    const float phi = 2.0f * pi * u.y;
    return frame_around(direction).to_world(
        {radius * std::cos(phi), radius * std::sin(phi), 1.0f - height});
  }

  /// Its solid angle 2 pi (1 - cos) times its radiance E / (pi sin^2), the 1 - cos cancelled.
  [[nodiscard]] float weight() const { return 2.0f * irradiance / (1.0f + std::cos(angle)); }
};
// [far-lamp]

// [lit-ball]
/// One estimate of what the lamp's light does to the row: f cos L / p, as in chapter 5, with
/// directions that all end at the lamp. Nothing stands in the lamp's way, and no light goes from
/// ball to ball.
/// @param brdfs  one for each ball
[[nodiscard]] inline Rgb lamp_light(const Scene& row, const std::vector<AnyBrdf>& brdfs,
                                    const FarLamp& lamp, const Ray& ray, Pcg32& random) {
  const auto hit = closest_hit(row, ray);
  if (!hit) return Rgb(0.02f);  // a backdrop, so that dark rims are seen
  const Frame frame = frame_around(point_on(row.spheres[hit->object], ray.at(hit->t)).normal);
  const vec3 wo = frame.to_local(-ray.direction);
  const vec3 wi = frame.to_local(lamp.sample(random.next_vec2()));
  return brdfs[hit->object](wo, wi) * (std::max(0.0f, wi.z) * lamp.weight());
}
// [lit-ball]

// [sky-ball]
/// Albedos of one BRDF at 65 cosines from 0 to 1, to look up between.
class AlbedoTable {
 public:
  /// @param steps  of the quadrature
  AlbedoTable(const AnyBrdf& brdf, float alpha, int steps) {
    for (int i = 0; i <= intervals; ++i) {
      const float mu = std::max(1e-3f, static_cast<float>(i) / intervals);
      albedos_.push_back(static_cast<float>(albedo(brdf, alpha, at_cosine(mu), steps)));
    }
  }

  /// @param mu  0 to 1
  [[nodiscard]] float at(float mu) const {
    const float place = std::clamp(mu, 0.0f, 1.0f) * intervals;
    const auto i = std::min(static_cast<std::size_t>(place), std::size_t{intervals - 1});
    return glm::mix(albedos_[i], albedos_[i + 1], place - static_cast<float>(i));
  }

 private:
  static constexpr int intervals = 64;
  std::vector<float> albedos_;
};

/// The row under a sky of radiance 1/2 that is the same everywhere. A ball that loses no light
/// cannot be seen.
[[nodiscard]] inline Rgb sky_light(const Scene& row, const std::vector<AlbedoTable>& albedos,
                                   const Ray& ray) {
  const float sky = 0.5f;
  const auto hit = closest_hit(row, ray);
  if (!hit) return Rgb(sky);
  const vec3 normal = point_on(row.spheres[hit->object], ray.at(hit->t)).normal;
  return Rgb(sky * albedos[hit->object].at(-dot(normal, ray.direction)));
}
// [sky-ball]

}  // namespace lt
