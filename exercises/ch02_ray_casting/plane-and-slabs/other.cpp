// No intervals: a box is six rectangles, and the nearest one that the ray crosses counts. The plane
// is met where the height above it has shrunk to 0.
#include "api.hpp"

#include <cmath>

namespace exercise {

namespace {

bool is_between(double lower, double x, double upper) {
  return lower <= x && x <= upper;
}

// Where the ray crosses the rectangle of the box that lies at `level` on `axis`.
std::optional<double> cross_face(const Box& box, const Ray& ray, int axis, double level) {
  if (ray.direction[axis] == 0.0) return std::nullopt;  // along the face, through its neighbours
  const double t = (level - ray.origin[axis]) / ray.direction[axis];
  const glm::dvec3 point = ray.origin + t * ray.direction;
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3})
    if (!is_between(box.lower[other], point[other], box.upper[other])) return std::nullopt;
  return t;
}

}  // namespace

std::optional<double> intersect(const Plane& plane, const Ray& ray) {
  const double height = dot(ray.origin - plane.point, plane.normal);
  const double sinking = -dot(ray.direction, plane.normal);  // metres for each unit of t
  const bool comes_nearer = (height > 0.0 && sinking > 0.0) || (height < 0.0 && sinking < 0.0);
  if (!comes_nearer) return std::nullopt;
  return height / sinking;
}

std::optional<double> intersect(const Box& box, const Ray& ray) {
  std::optional<double> nearest;
  for (int axis = 0; axis < 3; ++axis)
    for (const double level : {box.lower[axis], box.upper[axis]}) {
      const auto t = cross_face(box, ray, axis, level);
      if (t && *t > 0.0 && (!nearest || *t < *nearest)) nearest = t;
    }
  return nearest;
}

}  // namespace exercise
