/// @file
/// Exercise 02.4: what you write and what the checker calls.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Points origin + t * direction, t > 0.
struct Ray {
  glm::dvec3 origin;     ///< metres
  glm::dvec3 direction;  ///< of any length but 0; components may be 0, and -0 too
};

/// An endless plane through `point`, across `normal`.
struct Plane {
  glm::dvec3 point;   ///< metres
  glm::dvec3 normal;  ///< unit; either of the two
};

/// All points with lower <= point <= upper, in x, in y and in z. Its faces belong to it.
struct Box {
  glm::dvec3 lower, upper;  ///< metres; lower <= upper, and where they are equal the box is flat
};

/// Where a ray meets a plane, from either side.
/// @return t, greater than 0 and finite, or nothing
[[nodiscard]] std::optional<double> intersect(const Plane& plane, const Ray& ray);

/// Where a ray enters a box, or, if it starts inside or on a face, where it leaves.
/// @return t, greater than 0 and finite, or nothing
[[nodiscard]] std::optional<double> intersect(const Box& box, const Ray& ray);

}  // namespace exercise
