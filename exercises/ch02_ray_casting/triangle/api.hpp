/// @file
/// Exercise 02.3: what you write and what the checker calls.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Points origin + t * direction, t > 0.
struct Ray {
  glm::dvec3 origin;     ///< metres
  glm::dvec3 direction;  ///< of any length but 0
};

/// Three corners, not on one line.
struct Triangle {
  glm::dvec3 p0, p1, p2;  ///< metres
};

/// A point of a triangle on a ray, said in two ways.
struct TriangleHit {
  double t;            ///< the point is origin + t * direction; greater than 0
  glm::dvec3 weights;  ///< the point is weights.x * p0 + weights.y * p1 + weights.z * p2; sum 1
};

/// Where a ray meets a triangle, from either side.
/// @return nothing if it misses, has the triangle behind it, or runs parallel to it
[[nodiscard]] std::optional<TriangleHit> intersect(const Triangle& triangle, const Ray& ray);

}  // namespace exercise
