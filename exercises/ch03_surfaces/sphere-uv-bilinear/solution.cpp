#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

namespace {

const double pi = std::acos(-1.0);

// Texel i of a row of n that repeats without end. In C++, -1 % 4 is -1, not 3.
int wrap(int i, int n) {
  const int rest = i % n;
  return rest < 0 ? rest + n : rest;
}

}  // namespace

glm::dvec2 sphere_uv(glm::dvec3 n) {
  const double longitude = std::atan2(n.x, -n.z);  // 0 at the front, growing to the right
  // A normal a hair too long has no arc cosine: NaN, and a hole at the pole.
  const double from_pole = std::acos(std::clamp(n.y, -1.0, 1.0));
  return {0.5 + longitude / (2.0 * pi), from_pole / pi};
}

double bilinear(const Texture& texture, glm::dvec2 uv) {
  // In texels from the *middle* of texel 0: a texel is a square, and its value sits in its middle.
  const glm::dvec2 p = uv * glm::dvec2(texture.width, texture.height) - 0.5;
  const glm::dvec2 corner = glm::floor(p);  // not a cast, which rounds -0.5 up to 0
  const glm::dvec2 f = p - corner;

  const int x0 = wrap(static_cast<int>(corner.x), texture.width);
  const int y0 = wrap(static_cast<int>(corner.y), texture.height);
  const int x1 = wrap(x0 + 1, texture.width);
  const int y1 = wrap(y0 + 1, texture.height);
  const double upper = glm::mix(texture.at(x0, y0), texture.at(x1, y0), f.x);
  const double lower = glm::mix(texture.at(x0, y1), texture.at(x1, y1), f.x);
  return glm::mix(upper, lower, f.y);
}

}  // namespace exercise
