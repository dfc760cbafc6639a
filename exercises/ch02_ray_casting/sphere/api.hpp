/// @file
/// Exercise 02.2: what you write and what the checker calls.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "common/testkit/not_written.hpp"

namespace exercise {

struct Sphere {
  glm::vec3 center;
  float radius;  ///< > 0
};

/// Points origin + t * direction.
struct Ray {
  glm::vec3 origin;
  glm::vec3 direction;  ///< of any length but 0: t counts in lengths of it
};

/// The first crossing of the ray with the sphere's surface, from outside or inside.
/// @param t_min, t_max  only t_min < t < t_max counts; 0 <= t_min
/// @return the smallest such t, or nothing; a ray that touches the sphere crosses it once
[[nodiscard]] std::optional<float> intersect(const Sphere& sphere, const Ray& ray, float t_min,
                                             float t_max);

}  // namespace exercise
