#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace exercise {

std::optional<double> intersect(const Plane& /*plane*/, const Ray& /*ray*/) {
  TODO("find t, and refuse what is behind the ray or parallel to it");
}

std::optional<double> intersect(const Box& /*box*/, const Ray& /*ray*/) {
  TODO("find when the ray is in all three slabs at once");
}

}  // namespace exercise
