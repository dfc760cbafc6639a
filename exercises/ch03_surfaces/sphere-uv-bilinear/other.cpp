// No arc cosine, and no corner: the angle from the pole is the arc tangent of two sides, and every
// texel of the picture is asked how near it is.
#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

namespace {

// Weight of a texel whose middle is `distance` texels away along one axis of n texels, going round
// the shorter way; a row of one or two texels meets itself from both sides.
double weight(double distance, int n) {
  double sum = 0.0;
  distance = std::remainder(distance, n);
  for (const int round : {-n, 0, n})
    sum += std::max(0.0, 1.0 - std::abs(distance + round));
  return sum;
}

}  // namespace

glm::dvec2 sphere_uv(glm::dvec3 n) {
  const double turn = 2.0 * std::acos(-1.0);
  const double from_axis = std::hypot(n.x, n.z);
  return {0.5 - std::atan2(-n.x, -n.z) / turn, 2.0 * std::atan2(from_axis, n.y) / turn};
}

double bilinear(const Texture& texture, glm::dvec2 uv) {
  double sum = 0.0;
  for (int y = 0; y < texture.height; ++y)
    for (int x = 0; x < texture.width; ++x)
      sum += texture.at(x, y) * weight(uv.x * texture.width - x - 0.5, texture.width) *
             weight(uv.y * texture.height - y - 0.5, texture.height);
  return sum;
}

}  // namespace exercise
