#include "api.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::about;
using exercise::product;
using exercise::Quaternion;
using exercise::rotate;
using exercise::sphere_u;
using exercise::spin;
using glm::vec3;

const float pi = std::acos(-1.0f);
constexpr vec3 x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

std::string shown(vec3 v) {
  std::ostringstream text;
  text.precision(3);
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

std::string shown(Quaternion q) {
  std::ostringstream text;
  text.precision(3);
  text << q.w << " + " << q.x << " i + " << q.y << " j + " << q.z << " k";
  return text.str();
}

bool is_near(vec3 a, vec3 b, float tolerance = 1e-5f) {
  return glm::distance(a, b) <= tolerance;  // false for NaN
}

bool is_same(Quaternion a, Quaternion b, float tolerance = 1e-5f) {
  return std::abs(a.w - b.w) <= tolerance &&
         is_near(vec3(a.x, a.y, a.z), vec3(b.x, b.y, b.z), tolerance);
}

float length_of(Quaternion q) {
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

Quaternion random_rotation(lt::TestRandom& random) {
  const vec3 axis(random.direction());
  return about(axis, static_cast<float>(random.uniform(-6.0, 6.0)));
}

}  // namespace

TEST_CASE("a quarter turn about y takes z to x") {
  const vec3 turned = rotate(about(y_axis, pi / 2), z_axis);
  lt::diagnose(!is_near(turned, -z_axis), "half-angle-forgotten",
               "90 degrees about y took (0, 0, 1) to " + shown(turned) + " instead of (1, 0, 0).");
  CHECK(is_near(turned, x_axis));
  CHECK(is_near(rotate(about(y_axis, pi / 2), x_axis), -z_axis));
  CHECK(is_near(rotate(about(x_axis, pi / 2), y_axis), z_axis));
  CHECK(is_near(rotate(about(z_axis, pi / 2), x_axis), y_axis));
  CHECK(is_near(rotate(about(z_axis, -pi / 2), y_axis), x_axis));
}

TEST_CASE("i times j is k") {
  const Quaternion i{0, 1, 0, 0}, j{0, 0, 1, 0}, k{0, 0, 0, 1}, minus_k{0, 0, 0, -1};
  const Quaternion ij = product(i, j);
  lt::diagnose(!is_same(ij, minus_k), "product-reversed",
               "i j gave " + shown(ij) + " and should give k.");
  CHECK(is_same(ij, k));
  CHECK(is_same(product(j, i), minus_k));
  CHECK(is_same(product(k, k), {-1, 0, 0, 0}));
  const Quaternion q{0.5f, -0.5f, 0.5f, 0.5f};
  CHECK(is_same(product({1, 0, 0, 0}, q), q));
  CHECK(is_same(product(q, {1, 0, 0, 0}), q));
}

TEST_CASE("a product turns by its right factor first") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int n = 0; n < 50; ++n) {
      const Quaternion a = random_rotation(random);
      const Quaternion b = random_rotation(random);
      const vec3 v(random.direction());
      REQUIRE(is_near(rotate(product(a, b), v), rotate(a, rotate(b, v))));
    }
  }
}

TEST_CASE("turning keeps lengths and angles, and its axis") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int n = 0; n < 50; ++n) {
      const vec3 axis(random.direction());
      const auto angle = static_cast<float>(random.uniform(-6.0, 6.0));
      const Quaternion q = about(axis, angle);
      const Quaternion negative{-q.w, -q.x, -q.y, -q.z};
      const vec3 v(random.direction());
      const vec3 w(random.direction());
      REQUIRE(is_near(rotate(q, axis), axis));
      REQUIRE(std::abs(glm::dot(rotate(q, v), rotate(q, w)) - glm::dot(v, w)) < 1e-5f);
      REQUIRE(is_near(rotate(negative, v), rotate(q, v)));  // q and -q are one rotation
      // Rodrigues 1840.
      const vec3 by_formula = std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v) +
                              (1 - std::cos(angle)) * glm::dot(axis, v) * axis;
      REQUIRE(is_near(rotate(q, v), by_formula));
    }
  }
}

TEST_CASE("a turned globe shows another longitude") {
  const float turn = pi / 5;  // 36 degrees: u moves by 0.1
  const float u = sphere_u(about(y_axis, turn), -z_axis);
  // Turned the wrong way, 0.4. With the half angle forgotten, 0.7: that is another mistake.
  lt::diagnose(std::abs(u - 0.4f) > 1e-4f, "not-turned-back",
               "36 degrees about y brought u = " + std::to_string(u) +
                   " to the front and should bring 0.6.");
  CHECK(std::abs(u - 0.6f) < 1e-5f);
  CHECK(std::abs(sphere_u({1, 0, 0, 0}, x_axis) - 0.75f) < 1e-5f);
  // A quarter turn about z takes x to y: what is on top now was on the right.
  CHECK(std::abs(sphere_u(about(z_axis, pi / 2), y_axis) - 0.75f) < 1e-5f);
}

TEST_CASE("after a million spins the quaternion is still unit") {
  Quaternion q{1, 0, 0, 0};
  Quaternion plain = q;
  const Quaternion step = about(glm::normalize(vec3(1, 2, 3)), 0.01f);
  for (int n = 0; n < 1'000'000; ++n) {
    q = spin(q, step);
    plain = product(step, plain);
  }
  const float length = length_of(q);
  lt::diagnose(std::abs(length_of(plain) - 1.0f) < 1e-4f || !is_same(q, plain, 1e-6f),
               "never-normalised",
               "After a million spins its length is " + std::to_string(length) + ".");
  CHECK(std::abs(length - 1.0f) < 1e-5f);
  std::ostringstream text;
  text << "a million products without care end at length " << length_of(plain) << ", your spins at "
       << length;
  lt::measured(text.str());
}

TEST_CASE("spinning turns further") {
  const Quaternion quarter = about(y_axis, pi / 2);
  const Quaternion tilted = about(x_axis, pi / 2);                // y to z
  CHECK(is_near(rotate(spin(tilted, quarter), y_axis), x_axis));  // then z to x
}
