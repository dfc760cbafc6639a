/// @file
/// What a search costs, measured.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "ch02_ray_casting/mistakes.hpp"
#include "ch02_ray_casting/surface_point.hpp"
#include "ch02_ray_casting/three_sphere_room.hpp"
#include "common/timing.hpp"

namespace lt {

/// Time per ray for a scene of so many spheres.
struct Cost {
  double spheres;
  double nanoseconds;
};

/// Two ways of searching: every object once, and every object against every other.
struct Costs {
  std::vector<Cost> once;
  std::vector<Cost> pairs;
};

/// Spheres of radius 1 m, scattered over a cube of 100 m around the origin.
[[nodiscard]] inline Scene scattered_spheres(int count) {
  std::mt19937 bits(1);  // chapter 4 looks into such boxes
  const auto coordinate = [&] { return 100.0f * (static_cast<float>(bits()) * 0x1p-32f - 0.5f); };
  Scene scene;
  for (int i = 0; i < count; ++i) {
    const float x = coordinate();
    const float y = coordinate();
    const float z = coordinate();
    scene.spheres.push_back({{x, y, z}, 1.0f});
  }
  return scene;
}

/// Rays from the origin, evenly spread in all directions (a Fibonacci lattice).
[[nodiscard]] inline std::vector<Ray> fan(int count) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(count);
    const float radius = std::sqrt(1.0f - y * y);
    const float angle = 2.3999632f * static_cast<float>(i);
    rays.push_back({vec3(0.0f), {radius * std::cos(angle), y, radius * std::sin(angle)}});
  }
  return rays;
}

/// Processor time of one `search(ray)`, nanoseconds.
/// @param count  how many searches make a run; `rays` are taken in turns
template <class Search>
[[nodiscard]] double time_per_ray(const std::vector<Ray>& rays, int count, const Search& search) {
  std::size_t next = 0;
  return best_nanoseconds(count, [&](int) {
    const auto hit = search(rays[next]);
    if (++next == rays.size()) next = 0;
    return hit ? hit->t : 0.0f;
  });
}

/// Measures on this machine; takes some seconds.
[[nodiscard]] inline Costs measure_costs() {
  const std::vector<Ray> rays = fan(4096);
  Costs costs;
  for (int n = 1; n <= 1024; n *= 2) {
    const Scene scene = scattered_spheres(n);
    const auto once = [&](const Ray& ray) { return closest_hit(scene, ray); };
    const auto pairs = [&](const Ray& ray) { return mistakes::closest_hit(scene, ray); };
    const auto spheres = static_cast<double>(n);
    costs.once.push_back({spheres, time_per_ray(rays, 16'000'000 / (n + 8), once)});
    if (n > 256) continue;
    costs.pairs.push_back({spheres, time_per_ray(rays, 8'000'000 / (n * n + 8), pairs)});
  }
  return costs;
}

/// Nanoseconds for one ray of the far camera into the room: camera, search and surface point.
[[nodiscard]] inline double measure_room() {
  const Scene scene = three_sphere_room();
  const Camera camera = room_camera_far();
  std::vector<Ray> pixels;  // (x, y) packed into a ray's origin
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 225; ++x)
      pixels.push_back({{x, y, 0.0f}, {}});
  return time_per_ray(pixels, 1'000'000, [&](const Ray& pixel) {
    const Ray ray = camera_ray(camera, vec2(pixel.origin) + 0.5f, 225, 180);
    auto hit = closest_hit(scene, ray);
    if (hit) hit->t += surface_point(scene, ray, *hit).normal.x;
    return hit;
  });
}

/// The measured times as text, in the form that stored_costs() wants.
[[nodiscard]] inline std::string table(const Costs& costs) {
  std::string text;
  for (const auto& list : {costs.once, costs.pairs}) {
    for (const Cost& cost : list) {
      char entry[64];
      std::snprintf(entry, sizeof entry, "{%.0f, %.1f}, ", cost.spheres, cost.nanoseconds);
      text += entry;
    }
    text += '\n';
  }
  return text;
}

}  // namespace lt
