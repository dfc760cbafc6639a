// No determinant: first the plane, then the point in it, then the three smaller triangles that the
// point makes with the edges. Each has its share of the area.
#include "api.hpp"

namespace exercise {

namespace {

// Twice the area of a, b, c, as a vector across it.
glm::dvec3 area(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  return cross(b - a, c - a);
}

}  // namespace

std::optional<TriangleHit> intersect(const Triangle& triangle, const Ray& ray) {
  const auto& [p0, p1, p2] = triangle;
  const glm::dvec3 whole = area(p0, p1, p2);
  const double approach = dot(whole, ray.direction);
  if (approach == 0.0) return std::nullopt;

  const double t = dot(whole, p0 - ray.origin) / approach;
  if (t <= 0.0) return std::nullopt;

  const glm::dvec3 point = ray.origin + t * ray.direction;
  const glm::dvec3 weights{dot(area(point, p1, p2), whole), dot(area(p0, point, p2), whole),
                           dot(area(p0, p1, point), whole)};
  for (int i = 0; i < 3; ++i)
    if (weights[i] < 0.0) return std::nullopt;
  return TriangleHit{t, weights / (weights.x + weights.y + weights.z)};
}

}  // namespace exercise
