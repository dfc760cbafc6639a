// No quadratic: walk to the point of the line that is nearest to the centre, then half a chord back
// or on. Pythagoras gives the chord.
#include "api.hpp"

#include <cmath>

namespace exercise {

std::optional<float> intersect(const Sphere& sphere, const Ray& ray, float t_min, float t_max) {
  const float length = glm::length(ray.direction);
  const glm::vec3 unit = ray.direction / length;
  const float to_middle = glm::dot(sphere.center - ray.origin, unit);
  const float from_center = glm::distance(ray.origin + to_middle * unit, sphere.center);
  if (from_center > sphere.radius) return std::nullopt;

  const float half_chord = std::sqrt((sphere.radius - from_center) * (sphere.radius + from_center));
  const float entry = (to_middle - half_chord) / length;
  const float exit = (to_middle + half_chord) / length;
  if (entry > t_min) return entry < t_max ? std::optional(entry) : std::nullopt;
  return exit > t_min && exit < t_max ? std::optional(exit) : std::nullopt;
}

}  // namespace exercise
