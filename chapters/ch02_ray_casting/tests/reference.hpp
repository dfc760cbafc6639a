/// @file
/// The same questions asked in other words and in double precision: what the tests compare with.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <optional>

#include "ch02_ray_casting/surface_point.hpp"
#include "common/testkit/exercise.hpp"

namespace lt::reference {

using glm::dvec3;

inline constexpr double nowhere = std::numeric_limits<double>::infinity();

/// Half the distance from 1 to the next float: the largest relative error of one rounding.
inline constexpr double u = 0x1p-24;

/// Where a ray meets a sphere, by the school formula for a t^2 + 2 b t + c = 0 in long double. It
/// does not ask that the direction be unit.
struct SphereRoots {
  long double discriminant;  ///< b^2 - a c
  double near, far;          ///< `nowhere` without roots
  double miss_distance;      ///< of the line from the centre, metres
};

inline SphereRoots sphere_roots(const Sphere& sphere, const Ray& ray) {
  using Long = glm::vec<3, long double>;
  const Long d(ray.direction);
  const Long from_center = Long(ray.origin) - Long(sphere.center);
  const long double a = dot(d, d);
  const long double b = dot(from_center, d);
  const long double r = sphere.radius;
  const long double c = dot(from_center, from_center) - r * r;
  const long double discriminant = b * b - a * c;
  const long double square = dot(from_center, from_center) - b * b / a;
  const double miss = static_cast<double>(std::sqrt(std::max(square, 0.0L)));
  if (discriminant < 0) return {discriminant, nowhere, nowhere, miss};
  const long double root = std::sqrt(discriminant);
  return {discriminant, static_cast<double>((-b - root) / a), static_cast<double>((-b + root) / a),
          miss};
}

/// Where a ray meets the plane of a triangle, and the weights of the three corners there: Moeller
/// and Trumbore (1997) in double precision.
struct TriangleHit {
  double t;
  dvec3 weights;
};

inline TriangleHit moeller_trumbore(dvec3 p0, dvec3 p1, dvec3 p2, dvec3 origin, dvec3 direction) {
  const dvec3 edge1 = p1 - p0;
  const dvec3 edge2 = p2 - p0;
  const dvec3 p = cross(direction, edge2);
  const double determinant = dot(edge1, p);
  const dvec3 s = origin - p0;
  const dvec3 q = cross(s, edge1);
  const double w1 = dot(s, p) / determinant;
  const double w2 = dot(direction, q) / determinant;
  return {dot(edge2, q) / determinant, {1 - w1 - w2, w1, w2}};
}

inline TriangleHit triangle_hit(const Triangle& triangle, const Ray& ray) {
  return moeller_trumbore(dvec3(triangle.corner(0)), dvec3(triangle.corner(1)),
                          dvec3(triangle.corner(2)), dvec3(ray.origin), dvec3(ray.direction));
}

inline double ground_t(const Ground& ground, const Ray& ray) {
  return (static_cast<double>(ground.level) - ray.origin.y) / ray.direction.y;
}

}  // namespace lt::reference

namespace lt {

/// Random things to try, from a fixed seed.
class RandomCases {
 public:
  explicit RandomCases(std::uint64_t seed) : random_(seed) {}

  float uniform(float low, float high) { return static_cast<float>(random_.uniform(low, high)); }
  /// 10 to a power between `low` and `high`: as many small numbers as large ones.
  float any_size(float low, float high) {
    return static_cast<float>(std::pow(10.0, random_.uniform(low, high)));
  }
  vec3 direction() { return normalize(vec3(random_.direction())); }
  vec3 point_within(float size) {
    const float x = uniform(-size, size);
    const float y = uniform(-size, size);
    return {x, y, uniform(-size, size)};
  }
  /// On the side of the surface to which `normal` points.
  vec3 direction_above(vec3 normal) {
    const vec3 way = direction();
    return dot(way, normal) < 0.0f ? -way : way;
  }
  /// Corners of a triangle whose smallest angle is not tiny: twice its area is at least a fifth of
  /// the product of two edges.
  Triangle triangle(vec3 around, float size) {
    while (true) {
      const vec3 p0 = around + point_within(size);
      const vec3 p1 = around + point_within(size);
      const vec3 p2 = around + point_within(size);
      const glm::dvec3 a = glm::dvec3(p1) - glm::dvec3(p0);
      const glm::dvec3 b = glm::dvec3(p2) - glm::dvec3(p0);
      const glm::dvec3 c = b - a;
      const double longest = std::max({dot(a, a), dot(b, b), dot(c, c)});
      if (length(glm::cross(a, b)) > 0.2 * longest) return {p0, p1, p2};
    }
  }

 private:
  TestRandom random_;
};

/// The 26 directions from the middle of a cube to its faces, edges and corners: 18 of them have
/// components that are exactly 0.
inline std::vector<vec3> cube_directions() {
  std::vector<vec3> all;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) all.push_back(normalize(vec3(x, y, z)));
  return all;
}

}  // namespace lt
