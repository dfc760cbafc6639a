/// @file
/// A scene of spheres, triangles and grounds, and the search for the closest hit.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ch02_ray_casting/ground.hpp"
#include "ch02_ray_casting/sphere.hpp"
#include "ch02_ray_casting/triangle.hpp"

namespace lt {

// [scene]
/// Objects are numbered through: first the spheres, then the triangles, then the grounds.
/// Geometry only; what an object looks like is kept elsewhere, under the same number.
struct Scene {
  std::vector<Sphere> spheres;
  std::vector<Triangle> triangles;
  std::vector<Ground> grounds;

  [[nodiscard]] std::size_t object_count() const {
    return spheres.size() + triangles.size() + grounds.size();
  }
};

/// The winner of the search, and nothing that only the winner needs.
struct Hit {
  float t;               ///< distance along the ray, metres
  std::uint32_t object;  ///< its number in the scene
};
// [scene]

// [closest-hit]
/// The nearest object along a ray, by asking every object once: O(n).
/// @param t_max  hits at t >= t_max do not count
[[nodiscard]] inline std::optional<Hit> closest_hit(const Scene& scene, const Ray& ray,
                                                    float t_max = infinity) {
  std::optional<Hit> closest;
  std::uint32_t object = 0;
  const auto search = [&](const auto& shapes) {
    for (const auto& shape : shapes) {
      if (const auto t = intersect(shape, ray, t_max)) {
        closest = Hit{*t, object};
        t_max = *t;  // from now on only something nearer counts
      }
      ++object;
    }
  };
  search(scene.spheres);
  search(scene.triangles);
  search(scene.grounds);
  return closest;
}
// [closest-hit]

}  // namespace lt
