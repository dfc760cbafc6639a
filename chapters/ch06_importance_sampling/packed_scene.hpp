/// @file
/// The same shapes in another order in memory, so that one instruction asks several of them.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "ch05_rendering_equation/traceable.hpp"

namespace lt {

// [lanes]
/// How many shapes make a block. Processors work on 4, 8 or 16 floats at once: 8 suits them all.
inline constexpr int lanes = 8;

/// One number of each shape of a block.
using Lanes = std::array<float, lanes>;

/// One vector of each shape of a block: not x y z x y z, but all x, all y, all z.
struct Vec3Lanes {
  Lanes x{}, y{}, z{};

  void set(int lane, vec3 v) {
    x[lane] = v.x;
    y[lane] = v.y;
    z[lane] = v.z;
  }
  [[nodiscard]] vec3 get(int lane) const { return {x[lane], y[lane], z[lane]}; }
};

/// Lanes without a sphere have the radius NaN: no comparison with it is true, so no ray hits them.
struct SphereBlock {
  Vec3Lanes center;
  Lanes radius;

  SphereBlock() { radius.fill(std::numeric_limits<float>::quiet_NaN()); }
};
/// Lanes without a triangle stay 0; the distance to them is 0 / 0, and no comparison is true.
struct TriangleBlock {
  Vec3Lanes corner[3];
  Vec3Lanes normal;
};
// [lanes]

// [packed-scene]
/// A scene whose shapes are packed for the search. Everything else is asked of the original.
struct PackedScene {
  const TexturedScene& scene;  ///< must outlive this
  std::vector<SphereBlock> spheres;
  std::vector<TriangleBlock> triangles;

  explicit PackedScene(const TexturedScene& textured) : scene(textured) {
    const Scene& shapes = scene.shapes;
    spheres.resize((shapes.spheres.size() + lanes - 1) / lanes);
    triangles.resize((shapes.triangles.size() + lanes - 1) / lanes);
    for (std::size_t i = 0; i < shapes.spheres.size(); ++i) {
      spheres[i / lanes].center.set(i % lanes, shapes.spheres[i].center);
      spheres[i / lanes].radius[i % lanes] = shapes.spheres[i].radius;
    }
    for (std::size_t i = 0; i < shapes.triangles.size(); ++i) {
      for (int corner = 0; corner < 3; ++corner)
        triangles[i / lanes].corner[corner].set(i % lanes, shapes.triangles[i].corner(corner));
      triangles[i / lanes].normal.set(i % lanes, shapes.triangles[i].normal());
    }
  }
};
// [packed-scene]

// [branch-free]
/// Chapter 2's distance to a sphere without a branch: infinity where it has none. A loop of such
/// functions becomes one instruction stream for many shapes.
[[nodiscard]] inline float distance_or_infinity(const Ray& ray, vec3 center, float radius) {
  const vec3 from_center = ray.origin - center;
  const float b = dot(from_center, ray.direction);
  const vec3 closest = from_center - b * ray.direction;
  const float discriminant = radius * radius - dot(closest, closest);
  const float q = -b - std::copysign(std::sqrt(std::max(0.0f, discriminant)), b);
  const float k = dot(from_center, from_center) - radius * radius;
  const float other = k / q;
  const float near = q < other ? q : other;
  const float far = q < other ? other : q;
  const float t = near > 0.0f ? near : far;
  return discriminant >= 0.0f && t > 0.0f ? t : infinity;
}
// [branch-free]

/// The same for a triangle.
[[nodiscard]] inline float distance_or_infinity(const Ray& ray, vec3 normal, vec3 corner0,
                                                vec3 corner1, vec3 corner2) {
  const vec3 p0 = corner0 - ray.origin;
  const vec3 p1 = corner1 - ray.origin;
  const vec3 p2 = corner2 - ray.origin;
  const float t = dot(normal, p0) / dot(normal, ray.direction);
  const float side01 = edge_side(p0, p1, ray.direction);
  const float side12 = edge_side(p1, p2, ray.direction);
  const float side20 = edge_side(p2, p0, ray.direction);
  const float least = std::min(std::min(side01, side12), side20);
  const float most = std::max(std::max(side01, side12), side20);
  return t > 0.0f && !(least < 0.0f && most > 0.0f) ? t : infinity;
}

// [closest-hit-packed]
/// The nearest object: the same hit as the linear scan's, digit for digit.
[[nodiscard]] inline std::optional<Hit> closest_hit(const PackedScene& packed, const Ray& ray) {
  // [scan]
  Hit closest{infinity, 0};
  const auto take_nearest = [&](const Lanes& t, std::size_t first) {
    for (int i = 0; i < lanes; ++i)
      if (t[i] < closest.t) closest = {t[i], static_cast<std::uint32_t>(first + i)};
  };
  Lanes t;
  for (std::size_t block = 0; block < packed.spheres.size(); ++block) {
    const SphereBlock& s = packed.spheres[block];
    for (int i = 0; i < lanes; ++i)
      t[i] = distance_or_infinity(ray, s.center.get(i), s.radius[i]);
    take_nearest(t, block * lanes);
  }
  // [scan]
  const Scene& shapes = packed.scene.shapes;
  for (std::size_t block = 0; block < packed.triangles.size(); ++block) {
    const TriangleBlock& s = packed.triangles[block];
    for (int i = 0; i < lanes; ++i)
      t[i] = distance_or_infinity(ray, s.normal.get(i), s.corner[0].get(i), s.corner[1].get(i),
                                  s.corner[2].get(i));
    take_nearest(t, shapes.spheres.size() + block * lanes);
  }
  for (std::size_t i = 0; i < shapes.grounds.size(); ++i) {
    const auto first = shapes.spheres.size() + shapes.triangles.size();
    if (const auto on_ground = intersect(shapes.grounds[i], ray, closest.t))
      closest = {*on_ground, static_cast<std::uint32_t>(first + i)};
  }
  if (closest.t == infinity) return std::nullopt;
  return closest;
}
// [closest-hit-packed]

[[nodiscard]] inline Surface surface_at(const PackedScene& packed, const Ray& ray, Hit hit) {
  return surface_at(packed.scene, ray, hit);
}
[[nodiscard]] inline Rgb background(const PackedScene& packed, vec3 direction) {
  return background(packed.scene, direction);
}

}  // namespace lt
