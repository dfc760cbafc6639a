#include "api.hpp"

#include <cmath>

namespace exercise {

namespace {

const float pi = std::acos(-1.0f);

float square(float x) {
  return x * x;
}

}  // namespace

float ggx_d(float alpha, glm::vec3 h) {
  if (!(h.z > 0.0f)) return 0.0f;
  // tan^2 is (x^2 + y^2) / z^2. Its z^2, squared with the bracket, cancels cos^4: what is left has
  // no tangent that could overflow, and no 1 - z^2, which for small angles has no digits.
  const float squared_sin = h.x * h.x + h.y * h.y;
  const float bracket = square(alpha) * square(h.z) + squared_sin;
  return square(alpha / bracket) / pi;
}

float brushed_ggx_d(glm::vec2 alphas, glm::vec3 h) {
  if (!(h.z > 0.0f)) return 0.0f;
  // Each component is measured with the width of its own axis.
  const float x = h.x / alphas.x;
  const float y = h.y / alphas.y;
  const float bracket = square(x) + square(y) + square(h.z);
  return 1.0f / (pi * alphas.x * alphas.y * square(bracket));
}

float ggx_d_between(float alpha, glm::vec3 wo, glm::vec3 wi) {
  // A mirror's normal is half-way between the directions.
  const glm::vec3 sum = wo + wi;
  if (sum == glm::vec3(0.0f)) return 0.0f;
  return ggx_d(alpha, glm::normalize(sum));
}

}  // namespace exercise
