#include "api.hpp"

#include <cmath>

namespace exercise {

namespace {

const float pi = std::acos(-1.0f);

glm::vec3 vector_part(Quaternion q) {
  return {q.x, q.y, q.z};
}

Quaternion conjugate(Quaternion q) {
  return {q.w, -q.x, -q.y, -q.z};
}

}  // namespace

Quaternion product(Quaternion a, Quaternion b) {
  const glm::vec3 r = vector_part(a);
  const glm::vec3 s = vector_part(b);
  // Only the cross product knows the order.
  const glm::vec3 v = a.w * s + b.w * r + glm::cross(r, s);
  return {a.w * b.w - glm::dot(r, s), v.x, v.y, v.z};
}

Quaternion about(glm::vec3 axis, float angle) {
  const float half = angle / 2.0f;  // q works from the left and q* from the right: each does half
  const glm::vec3 v = std::sin(half) * axis;
  return {std::cos(half), v.x, v.y, v.z};
}

glm::vec3 rotate(Quaternion q, glm::vec3 v) {
  // q v q*, multiplied out for unit q: two cross products instead of two quaternion products.
  const glm::vec3 r = vector_part(q);
  const glm::vec3 t = 2.0f * glm::cross(r, v);
  return v + q.w * t + glm::cross(r, t);
}

Quaternion spin(Quaternion now, Quaternion step) {
  const Quaternion q = product(step, now);
  const float length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

float sphere_u(Quaternion rotation, glm::vec3 n) {
  const glm::vec3 local = rotate(conjugate(rotation), n);  // back to where the map is
  return 0.5f + std::atan2(local.x, -local.z) / (2.0f * pi);
}

}  // namespace exercise
