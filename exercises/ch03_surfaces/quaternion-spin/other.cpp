// The sixteen products written out; rotation by two of them; no square root to stay unit; and the
// sphere's own axes turned into the world instead of the normal out of it.
#include "api.hpp"

#include <cmath>
#include <complex>

namespace exercise {

Quaternion product(Quaternion a, Quaternion b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Quaternion about(glm::vec3 axis, float angle) {
  // Around one axis a quaternion is a complex number that turns by half the angle.
  const std::complex<float> turn = std::polar(1.0f, 0.5f * angle);
  return {turn.real(), turn.imag() * axis.x, turn.imag() * axis.y, turn.imag() * axis.z};
}

glm::vec3 rotate(Quaternion q, glm::vec3 v) {
  const Quaternion turned = product(product(q, {0.0f, v.x, v.y, v.z}), {q.w, -q.x, -q.y, -q.z});
  return {turned.x, turned.y, turned.z};
}

Quaternion spin(Quaternion now, Quaternion step) {
  const Quaternion q = product(step, now);
  // One step of Newton towards 1 / length: next to 1 nothing more is needed.
  const float correction = 1.5f - 0.5f * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * correction, q.x * correction, q.y * correction, q.z * correction};
}

float sphere_u(Quaternion rotation, glm::vec3 n) {
  const float right = glm::dot(n, rotate(rotation, {1.0f, 0.0f, 0.0f}));
  const float back = glm::dot(n, rotate(rotation, {0.0f, 0.0f, 1.0f}));
  return 0.5f + std::atan2(right, -back) / (2.0f * std::acos(-1.0f));
}

}  // namespace exercise
