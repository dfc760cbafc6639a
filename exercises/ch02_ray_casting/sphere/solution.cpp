#include "api.hpp"

#include <cmath>

namespace exercise {

std::optional<float> intersect(const Sphere& sphere, const Ray& ray, float t_min, float t_max) {
  // a t^2 + 2 b t + k = 0. The factor 2 of b is left out, so that no 4 and no 2 remain below.
  const glm::vec3 from_center = ray.origin - sphere.center;
  const float a = glm::dot(ray.direction, ray.direction);
  const float b = glm::dot(from_center, ray.direction);
  const float k = glm::dot(from_center, from_center) - sphere.radius * sphere.radius;

  // b^2 - a k without subtracting the squares of a distance: far away, they have no digit left
  // for the radius. The line's nearest point to the centre is as near as it is.
  const glm::vec3 closest = from_center - (b / a) * ray.direction;
  const float discriminant = a * (sphere.radius * sphere.radius - glm::dot(closest, closest));
  if (discriminant < 0.0f) return std::nullopt;

  // q adds two numbers of the same sign. The product of the roots is k / a: the other is k / q.
  // Which of them is the near one depends on the sign of b.
  const float q = -b - std::copysign(std::sqrt(discriminant), b);
  const float near = std::fmin(q / a, k / q);
  const float far = std::fmax(q / a, k / q);
  for (const float t : {near, far})
    if (t > t_min && t < t_max) return t;
  return std::nullopt;
}

}  // namespace exercise
