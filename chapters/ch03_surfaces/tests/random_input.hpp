// Random inputs for the tests, the same with every compiler.
#pragma once

#include <cmath>
#include <random>

#include "ch03_surfaces/rotation.hpp"

namespace lt {

class RandomInput {
 public:
  explicit RandomInput(unsigned seed) : engine_(seed) {}

  float uniform(float low, float high) {
    return low + (high - low) * static_cast<float>(engine_() >> 8) * 0x1p-24f;
  }
  vec2 point(float low, float high) {
    const float x = uniform(low, high);
    const float y = uniform(low, high);
    return {x, y};
  }
  // Uniform on the sphere: heights are uniform (Archimedes), and so are longitudes.
  vec3 direction() {
    const float z = uniform(-1.0f, 1.0f);
    const float angle = uniform(-pi, pi);
    const float r = std::sqrt(1.0f - z * z);
    return normalize(vec3(r * std::cos(angle), r * std::sin(angle), z));
  }
  glm::quat rotation() {
    const vec3 axis = direction();
    return rotation_about(axis, uniform(-pi, pi));
  }

 private:
  std::mt19937 engine_;
};

}  // namespace lt
