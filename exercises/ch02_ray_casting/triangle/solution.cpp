#include "api.hpp"

namespace exercise {

namespace {

// Volume of the box with edges a, b and c, negative if they are the other hand's: the determinant
// of the matrix with these columns.
double volume(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  return dot(a, cross(b, c));
}

}  // namespace

std::optional<TriangleHit> intersect(const Triangle& triangle, const Ray& ray) {
  // s = -t d + b1 e1 + b2 e2: three equations for three unknowns, solved by Cramer's rule.
  const glm::dvec3 s = ray.origin - triangle.p0;
  const glm::dvec3 e1 = triangle.p1 - triangle.p0;
  const glm::dvec3 e2 = triangle.p2 - triangle.p0;
  const glm::dvec3 to_viewer = -ray.direction;

  // Positive from one side, negative from the other: both may hit. As small as the triangle: no
  // fixed number is "almost 0".
  const double whole = volume(to_viewer, e1, e2);
  const double t = volume(s, e1, e2) / whole;
  const double b1 = volume(to_viewer, s, e2) / whole;
  const double b2 = volume(to_viewer, e1, s) / whole;
  const double b0 = 1.0 - b1 - b2;

  // A parallel ray has divided by 0. Asked this way round, what is not a number is no hit.
  if (!(t > 0.0 && b0 >= 0.0 && b1 >= 0.0 && b2 >= 0.0)) return std::nullopt;
  return TriangleHit{t, {b0, b1, b2}};
}

}  // namespace exercise
