#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace exercise {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// From when to when. Empty if it ends before it begins.
struct Interval {
  double begin, end;
};

// When the coordinate o + t d lies between two faces.
Interval time_between(double lower, double upper, double o, double d) {
  // It never changes: between the faces always, or never. A division would give 0 / 0 on a face.
  if (d == 0.0)
    return lower <= o && o <= upper ? Interval{-infinity, infinity} : Interval{infinity, -infinity};

  double begin = (lower - o) / d;
  double end = (upper - o) / d;
  if (d < 0.0) std::swap(begin, end);  // it comes from above and meets the upper face first
  return {begin, end};
}

}  // namespace

std::optional<double> intersect(const Plane& plane, const Ray& ray) {
  const double t = dot(plane.normal, plane.point - ray.origin) / dot(plane.normal, ray.direction);
  // A parallel ray has divided by 0: t is infinite, or NaN within the plane.
  if (t > 0.0 && t < infinity) return t;
  return std::nullopt;
}

std::optional<double> intersect(const Box& box, const Ray& ray) {
  // Inside is where all three are between their faces: from the last entry to the first exit.
  double enter = -infinity;
  double exit = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const Interval slab =
        time_between(box.lower[axis], box.upper[axis], ray.origin[axis], ray.direction[axis]);
    enter = std::max(slab.begin, enter);
    exit = std::min(slab.end, exit);
  }
  const bool is_met = enter <= exit;  // equal in a flat box
  if (!is_met || exit <= 0.0) return std::nullopt;
  return enter > 0.0 ? enter : exit;  // from inside, the entry lies behind
}

}  // namespace exercise
