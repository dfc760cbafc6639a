// Quaternions against rotation matrices, which are older.
#include "ch03_surfaces/rotation.hpp"

#include <cmath>

#include "ch03_surfaces/tests/random_input.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// Rodrigues 1840, as a matrix: cos I + sin [a]x + (1 - cos) a a^T.
mat3 rotation_matrix(vec3 a, float angle) {
  const float c = std::cos(angle);
  const float s = std::sin(angle);
  const mat3 cross_with_a(0.0f, a.z, -a.y, -a.z, 0.0f, a.x, a.y, -a.x, 0.0f);  // column by column
  return c * mat3(1.0f) + s * cross_with_a + (1.0f - c) * glm::outerProduct(a, a);
}

constexpr vec3 x_axis(1.0f, 0.0f, 0.0f), y_axis(0.0f, 1.0f, 0.0f), z_axis(0.0f, 0.0f, 1.0f);

}  // namespace

TEST_CASE("rotations: a quarter turn about y takes z to x, and x to -z") {
  const glm::quat quarter = rotation_about(y_axis, pi / 2.0f);
  CHECK(distance(rotate(quarter, z_axis), x_axis) < 1e-6f);
  CHECK(distance(rotate(quarter, x_axis), -z_axis) < 1e-6f);
  CHECK(distance(rotate(quarter, y_axis), y_axis) < 1e-6f);
}

TEST_CASE("rotations: by quaternion equals by matrix") {
  RandomInput random(1);
  float worst = 0.0f;
  for (int i = 0; i < 100'000; ++i) {
    const vec3 axis = random.direction();
    const float angle = random.uniform(-2.0f * pi, 2.0f * pi);
    const vec3 v = random.direction();
    const vec3 by_matrix = rotation_matrix(axis, angle) * v;
    worst = std::max(worst, distance(rotate(rotation_about(axis, angle), v), by_matrix));
  }
  CHECK(worst < 2e-6f);
}

TEST_CASE("rotations: agree with the library's") {
  RandomInput random(2);
  for (int i = 0; i < 1000; ++i) {
    const glm::quat q = random.rotation();
    const vec3 v = random.direction();
    CHECK(distance(rotate(q, v), q * v) < 1e-6f);
    CHECK(distance(rotate(q, v), glm::mat3_cast(q) * v) < 1e-6f);
  }
}

TEST_CASE("rotations: turning back undoes turning") {
  RandomInput random(3);
  for (int i = 0; i < 1000; ++i) {
    const glm::quat q = random.rotation();
    const vec3 v = random.direction();
    CHECK(distance(rotate_back(q, rotate(q, v)), v) < 3e-6f);
  }
}

TEST_CASE("rotations: of a product, the right factor turns first") {
  const glm::quat about_x = rotation_about(x_axis, pi / 2.0f);         // y to z
  const glm::quat about_y = rotation_about(y_axis, pi / 2.0f);         // z to x
  CHECK(distance(rotate(about_y * about_x, y_axis), x_axis) < 1e-6f);  // y to z, z to x
  CHECK(distance(rotate(about_x * about_y, y_axis), z_axis) < 1e-6f);  // y to y, y to z
}

TEST_CASE("rotations: a quaternion and its negative are the same rotation") {
  RandomInput random(4);
  for (int i = 0; i < 1000; ++i) {
    const glm::quat q = random.rotation();
    const vec3 v = random.direction();
    CHECK(distance(rotate(-q, v), rotate(q, v)) < 1e-6f);
  }
}
