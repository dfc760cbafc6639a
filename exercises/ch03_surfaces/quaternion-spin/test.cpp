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
using glm::vec4;

const float pi = std::acos(-1.0f);
constexpr vec3 x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);
constexpr Quaternion one{1, 0, 0, 0}, i{0, 1, 0, 0}, j{0, 0, 1, 0}, k{0, 0, 0, 1};

// Room for arithmetic in float.
template <class T>
lt::CloseTo<T> close_to(T value) {
  return lt::close_to(value, 1e-5);
}

// (w, x, y, z)
vec4 numbers(Quaternion q) {
  return {q.w, q.x, q.y, q.z};
}

// To three decimals: 5e-8 is 0, and not -0.
double rounded(double x) {
  return std::isnan(x) ? std::abs(x) : std::round(1000 * x) / 1000 + 0.0;
}

std::string shown(vec3 v) {
  std::ostringstream text;
  text << '(' << rounded(v.x) << ", " << rounded(v.y) << ", " << rounded(v.z) << ')';
  return text.str();
}

std::string shown(Quaternion q) {
  std::ostringstream text;
  text << "w = " << rounded(q.w) << ", (x, y, z) = " << shown(vec3(q.x, q.y, q.z));
  return text.str();
}

std::string took(const std::string& turn, vec3 from, vec3 to, vec3 expected) {
  return turn + " took " + shown(from) + " to " + shown(to) + " instead of " + shown(expected) +
         ".";
}

Quaternion random_rotation(lt::TestRandom& random) {
  const vec3 axis(random.direction());
  return about(axis, static_cast<float>(random.uniform(-6.0, 6.0)));
}

// What later mistakes are told by, once these two are right.
bool product_is_right() {
  return numbers(product(i, j)) == close_to(numbers(k));
}
const Quaternion quarter_about_y{std::sqrt(0.5f), 0, std::sqrt(0.5f), 0};
bool rotate_is_right() {
  return rotate(quarter_about_y, z_axis) == close_to(x_axis);
}

}  // namespace

TEST_CASE("i times j is k") {
  const Quaternion ij = product(i, j);
  lt::diagnose(!(numbers(ij) == close_to(-numbers(k))), "product-reversed",
               "i j gave " + shown(ij) + ", which is -k, and should give k.");
  CHECK(numbers(product(i, j)) == close_to(numbers(k)));
  CHECK(numbers(product(j, i)) == close_to(-numbers(k)));
  CHECK(numbers(product(k, k)) == close_to(-numbers(one)));
  const Quaternion q{0.5f, -0.5f, 0.5f, 0.5f};
  CHECK(numbers(product(one, q)) == close_to(numbers(q)));
  CHECK(numbers(product(q, one)) == close_to(numbers(q)));
}

TEST_CASE("a quarter turn about y takes z to x") {
  // q k q = (k + i) (1 + j) / 2 = k, and q j q = j q q = j j = -1, which has no vector part.
  const vec3 along = rotate(quarter_about_y, y_axis);
  const bool is_across_kept = rotate(quarter_about_y, z_axis) == close_to(z_axis);
  lt::diagnose(!(is_across_kept && along == close_to(vec3(0))), "conjugate-forgotten",
               took("90 degrees about y", y_axis, along, y_axis));
  const vec3 turned = rotate(about(y_axis, pi / 2), z_axis);
  const std::string seen = took("90 degrees about y", z_axis, turned, x_axis);
  // Products in the wrong order turn q v q* into q* v q.
  lt::diagnose(!(turned == close_to(-x_axis)) || !product_is_right(), "turned-backwards", seen);
  lt::diagnose(!(turned == close_to(-z_axis)), "half-angle-forgotten", seen);
  CHECK(rotate(about(y_axis, pi / 2), z_axis) == close_to(x_axis));
  CHECK(rotate(about(y_axis, pi / 2), x_axis) == close_to(-z_axis));
  CHECK(rotate(about(x_axis, pi / 2), y_axis) == close_to(z_axis));
  CHECK(rotate(about(z_axis, pi / 2), x_axis) == close_to(y_axis));
  CHECK(rotate(about(z_axis, -pi / 2), y_axis) == close_to(x_axis));
}

TEST_CASE("turning follows the formula of Rodrigues") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int n = 0; n < 50; ++n) {
      const vec3 axis(random.direction());
      const auto angle = static_cast<float>(random.uniform(-6.0, 6.0));
      const Quaternion q = about(axis, angle);
      const vec3 v(random.direction());
      INFO(shown(v) << " turned by " << angle << " about " << shown(axis));
      // Rodrigues 1840; with it lengths and angles are kept.
      const vec3 by_formula = std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v) +
                              (1 - std::cos(angle)) * glm::dot(axis, v) * axis;
      REQUIRE(rotate(q, v) == close_to(by_formula));
      REQUIRE(rotate({-q.w, -q.x, -q.y, -q.z}, v) == close_to(by_formula));  // -q turns as q does
    }
  }
}

TEST_CASE("a product turns by its right factor first") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int n = 0; n < 50; ++n) {
      const Quaternion a = random_rotation(random);
      const Quaternion b = random_rotation(random);
      const vec3 v(random.direction());
      INFO("a = " << shown(a) << ", b = " << shown(b) << ", v = " << shown(v));
      REQUIRE(rotate(product(a, b), v) == close_to(rotate(a, rotate(b, v))));
    }
  }
}

TEST_CASE("a turned globe shows another longitude") {
  CHECK(sphere_u(one, -z_axis) == close_to(0.5f));
  CHECK(sphere_u(one, x_axis) == close_to(0.75f));
  const Quaternion turn = about(y_axis, pi / 5);  // 36 degrees: u moves by 0.1
  const float u = sphere_u(turn, -z_axis);
  // Turned with the sphere, 0.4. So it is where rotate() turns backwards, or u is mirrored: those
  // are other mistakes.
  const bool is_mirrored = sphere_u(one, x_axis) == close_to(0.25f);
  lt::diagnose(!(u == close_to(0.4f)) || is_mirrored || !rotate_is_right(), "not-turned-back",
               "36 degrees about y brought u = 0.4 to the front and should bring 0.6.");
  CHECK(sphere_u(turn, -z_axis) == close_to(0.6f));
  // A quarter turn about z takes x to y: what is on top now was on the right.
  CHECK(sphere_u(about(z_axis, pi / 2), y_axis) == close_to(0.75f));
}

TEST_CASE("a spin turns further") {
  const Quaternion tilted = about(x_axis, pi / 2);   // y to z
  const Quaternion quarter = about(y_axis, pi / 2);  // z to x
  const vec3 turned = rotate(spin(tilted, quarter), y_axis);
  const bool is_told_elsewhere = !rotate_is_right() || !product_is_right();
  // The step first leaves y where it is, and then it becomes z.
  lt::diagnose(!(turned == close_to(z_axis)) || is_told_elsewhere, "step-first",
               took("y to z, then spun from z to x,", y_axis, turned, x_axis));
  CHECK(rotate(spin(tilted, quarter), y_axis) == close_to(x_axis));
}

TEST_CASE("after a million spins the quaternion is still unit") {
  const Quaternion step = about(glm::normalize(vec3(1, 2, 3)), 0.01f);
  Quaternion q = one;
  Quaternion plain = one;
  double length_after_ten = 0;
  for (int n = 0; n < 1'000'000; ++n) {
    q = spin(q, step);
    plain = product(step, plain);
    if (n == 9) length_after_ten = glm::length(numbers(q));
  }
  const double length = glm::length(numbers(q));
  const bool has_grown = length_after_ten == close_to(1.0) && !(length == close_to(1.0));
  const bool is_told_elsewhere = !rotate_is_right() || !product_is_right();
  lt::diagnose(!has_grown || is_told_elsewhere, "never-normalised",
               "After ten spins its length is " + std::to_string(length_after_ten) +
                   ", after a million " + std::to_string(length) + ".");
  CHECK(length_after_ten == close_to(1.0));
  CHECK(length == close_to(1.0));
  std::ostringstream text;
  text << "a million products without care end at length " << glm::length(numbers(plain))
       << ", your spins at " << length;
  lt::measured(text.str());
}
