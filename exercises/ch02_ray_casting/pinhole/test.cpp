#include "api.hpp"

#include <cmath>
#include <ostream>
#include <sstream>
#include <string>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::Camera;
using exercise::camera_ray;
using exercise::look_at;
using exercise::Ray;
using glm::dmat3;
using glm::dvec2;
using glm::dvec3;
using glm::ivec2;
using glm::vec2;
using glm::vec3;

// A direction, seen or expected. Aiming between corners of the window adds numbers of up to 8 here
// (half its width 2, half its height 6), in some five steps that each round by 2^-24 of that:
// 2.4e-6, and four times as much is room for other orders.
struct Direction {
  dvec3 v;
};

bool operator==(const Direction& a, const Direction& b) {
  return glm::distance(a.v, b.v) <= 1e-5;  // false for NaN
}

std::string shown(dvec3 v) {
  std::ostringstream text;
  text.precision(6);
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

std::ostream& operator<<(std::ostream& out, const Direction& direction) {
  return out << shown(direction.v);
}

// What a check prints: one line, with all that belongs to it.
struct Comparison {
  bool is_equal;
  std::string text;
  explicit operator bool() const { return is_equal; }
};

std::ostream& operator<<(std::ostream& out, const Comparison& comparison) {
  return out << comparison.text;
}

Comparison same(const Direction& seen, const Direction& expected) {
  std::ostringstream text;
  text << seen << " instead of " << expected;
  return {seen == expected, text.str()};
}

Direction unit(dvec3 v) {
  return {glm::normalize(v)};
}

std::string gave(const std::string& what, double value, double expected) {
  std::ostringstream text;
  text.precision(4);
  text << what << " is " << value << " and should be " << expected << ".";
  return text.str();
}

std::string gave(const std::string& what, dvec3 value, dvec3 expected) {
  return what + " is " + shown(value) + " and should be " + shown(expected) + ".";
}

bool is_near(double a, double b, double tolerance = 1e-4) {
  return std::abs(a - b) <= tolerance;
}

// Whether a camera's axes are unit, perpendicular and left-handed as the world's.
Comparison is_sound(const Camera& camera) {
  const dvec3 axes[] = {camera.right, camera.up, camera.forward};
  const char* const names[] = {"right", "up", "forward"};
  std::ostringstream text;
  text.precision(4);
  for (int i = 0; i < 3; ++i) {
    const double length = glm::length(axes[i]);
    if (!is_near(length, 1, 5e-6)) text << names[i] << " is " << length << " long; ";
    const double cosine = glm::dot(axes[i], axes[(i + 1) % 3]);
    if (!is_near(cosine, 0, 5e-6))
      text << names[i] << " . " << names[(i + 1) % 3] << " is " << cosine << "; ";
  }
  const double determinant = glm::determinant(dmat3(axes[0], axes[1], axes[2]));
  if (!is_near(determinant, 1, 2e-5)) text << "the determinant is " << determinant << "; ";
  return {text.str().empty(), text.str()};
}

constexpr vec3 x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

// Looks along +z. Half of its field of view has the tangent 1/2, so that the window at distance 1
// is 1 wide; all of it has the tangent 2 (1/2) / (1 - 1/4) = 4/3.
const Camera straight{{0, 0, 0}, x_axis, y_axis, z_axis, 2.0f * std::atan(0.5f)};

// Where the ray through a point of a pixel pierces that window, in a picture of 8 x 5; nowhere
// (NaN) if it leaves backwards.
dvec2 on_window(ivec2 pixel, vec2 offset = vec2(0.5f)) {
  const dvec3 d(camera_ray(straight, pixel, offset, 8, 5).direction);
  return d.z > 0 ? dvec2(d) / d.z : dvec2(std::nan(""));
}

// From the middle of pixel (4, 1) to that of (5, 1), and to that of (4, 2).
double column_step() {
  return on_window({5, 1}).x - on_window({4, 1}).x;
}
double row_step() {
  return on_window({4, 2}).y - on_window({4, 1}).y;
}

// The column, in pixels from the left edge, through which the middle of pixel (1, 2) looks: 1.5.
double column_of_middle() {
  return 4 + on_window({1, 2}).x / column_step();
}

// A camera somewhere, with axes made here and not by look_at().
Camera random_camera(lt::TestRandom& random) {
  const dvec3 forward = random.direction();
  dvec3 aside = glm::cross(random.direction(), forward);
  while (glm::length(aside) < 0.1)
    aside = glm::cross(random.direction(), forward);
  const dvec3 right = glm::normalize(aside);
  const auto field_of_view = static_cast<float>(random.uniform(0.05, 2.2));
  return {vec3(10.0 * random.direction()), vec3(right), vec3(glm::cross(forward, right)),
          vec3(forward), field_of_view};
}

}  // namespace

TEST_CASE("a camera that looks along +z has the axes of the world") {
  const Camera camera = look_at({1, 2, 3}, {1, 2, 8}, y_axis, 1.0f);
  const Direction right{camera.right}, up{camera.up}, forward{camera.forward};
  lt::diagnose(!(forward == Direction{-z_axis}), "looks-away",
               gave("For a target along +z, forward", forward.v, z_axis));
  lt::diagnose(
      !(forward == Direction{z_axis} && up == Direction{y_axis} && right == Direction{-x_axis}),
      "mirrored", gave("For a target along +z, right", right.v, x_axis));
  CHECK(same(forward, Direction{z_axis}));
  CHECK(same(right, Direction{x_axis}));
  CHECK(same(up, Direction{y_axis}));
  CHECK(camera.position == vec3(1, 2, 3));
  CHECK(camera.field_of_view == 1.0f);
}

TEST_CASE("a camera that looks down keeps its horizon level and its axes perpendicular") {
  // 3 down and 4 ahead: the line of sight is 5 long.
  const Camera camera = look_at({0, 3, 0}, {0, 0, 4}, y_axis, 1.0f);
  const Direction right{camera.right}, up{camera.up}, forward{camera.forward};
  lt::diagnose(!(forward == unit({0, -3, 4}) && up == Direction{y_axis}), "world-up-kept",
               gave("Looking down from (0, 3, 0) to (0, 0, 4), up", up.v, {0, 0.8, 0.6}));
  // The cosine of the slope is 0.8, which is what y x forward is long.
  const double shortest = std::fmin(glm::length(right.v), glm::length(up.v));
  lt::diagnose(
      !(forward == unit({0, -3, 4}) && is_near(shortest, 0.8)), "axis-not-unit",
      gave("Looking down from (0, 3, 0) to (0, 0, 4), the length of an axis", shortest, 1));
  CHECK(same(forward, unit({0, -3, 4})));
  CHECK(same(right, Direction{x_axis}));
  CHECK(same(up, unit({0, 4, 3})));
  CHECK(is_sound(camera));
}

TEST_CASE("every camera has perpendicular unit axes, sees its target and stands upright") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 60; ++i) {
      const vec3 position(10.0 * random.direction());
      const vec3 target(dvec3(position) + random.uniform(0.5, 20) * random.direction());
      const vec3 up(random.direction());
      const dvec3 line_of_sight = glm::normalize(dvec3(target) - dvec3(position));
      if (glm::length(glm::cross(dvec3(up), line_of_sight)) < 0.3) continue;
      const Camera camera = look_at(position, target, up, 0.5f);
      INFO("position " << shown(position) << ", target " << shown(target) << ", up " << shown(up));
      REQUIRE(is_sound(camera));
      REQUIRE(same(Direction{camera.forward}, Direction{line_of_sight}));
      const double up_to_right = glm::dot(dvec3(up), dvec3(camera.right));
      REQUIRE(is_near(up_to_right, 0, 5e-6));  // the given up leans neither left nor right
      REQUIRE(glm::dot(up, camera.up) > 0.0f);
    }
  }
}

TEST_CASE("rays leave forward, in directions that do not depend on where the camera stands") {
  const Direction here{camera_ray(straight, {1, 1}, {0.5f, 0.5f}, 8, 5).direction};
  Camera moved = straight;
  moved.position = {1, 2, 3};
  const Ray there = camera_ray(moved, {1, 1}, {0.5f, 0.5f}, 8, 5);
  lt::diagnose(Direction{there.direction} == here, "position-added",
               "Through one and the same pixel, the direction is " + shown(here.v) +
                   " for a camera at 0 and " + shown(there.direction) + " for one at (1, 2, 3).");
  CHECK(there.origin == moved.position);
  CHECK(here.v.z > 0);
}

TEST_CASE("columns go to the right") {
  CHECK(column_step() > 0);
  CHECK(on_window({0, 2}).x < 0);
  CHECK(on_window({7, 2}).x > 0);
}

TEST_CASE("rows go downward") {
  const double down = row_step();
  lt::diagnose(!(down > 0), "rows-upward",
               gave("One row down, at distance 1, the change of y", down, -0.125));
  CHECK(down < 0);
  CHECK(on_window({4, 0}).y > 0);
  CHECK(on_window({4, 4}).y < 0);
}

TEST_CASE("the field of view reaches from the left edge to the right") {
  // 8 columns share a window that is 1 wide. The tangent of the whole angle makes it 8/3 wide; an
  // angle from top to bottom makes 5 rows share it.
  const double step = column_step();
  const std::string what = "In a picture of 8 x 5, at distance 1, a pixel's width";
  lt::diagnose(!is_near(step, 1.0 / 3), "field-not-halved", gave(what, step, 0.125));
  lt::diagnose(!is_near(step, 0.2), "vertical-field", gave(what, step, 0.125));
  CHECK(step == Approx(0.125).epsilon(1e-5));
}

TEST_CASE("one row is as far as one column") {
  const double across = column_step();
  const double down = std::abs(row_step());
  // The same window for 5 rows as for 8 columns.
  lt::diagnose(!is_near(down / across, 8.0 / 5), "aspect-forgotten",
               gave("In a picture of 8 x 5, a pixel's height over its width", down / across, 1));
  CHECK(down == Approx(across).epsilon(1e-5));
}

TEST_CASE("the offset says where in the pixel") {
  const double middle = column_of_middle();
  const dvec2 other = on_window({1, 2}, {0.25f, 0.75f});
  const bool is_ignored = glm::distance(other, on_window({1, 2})) < 1e-6;
  const bool is_step_right = is_near(column_step(), 0.125);
  const std::string what = "For pixel (1, 2) and offset (0.5, 0.5), x in pixels from the left edge";
  lt::diagnose(!(is_step_right && is_ignored && is_near(middle, 1)), "pixel-corner",
               gave(what, middle, 1.5));
  lt::diagnose(!(is_step_right && !is_ignored && is_near(middle, 2)), "half-added-twice",
               gave(what, middle, 1.5));
  const double middle_row = on_window({1, 2}).y;
  lt::diagnose(!(is_step_right && is_near(middle, 1.5) && is_near(middle_row, -0.0625)),
               "whole-number-half",
               gave("In a picture of 5 rows, y at the middle of row 2", middle_row, 0));
  CHECK(middle == Approx(1.5).epsilon(1e-5));
  CHECK(middle_row == Approx(0).margin(1e-5));
  INFO("pixel (1, 2), offset (0.25, 0.75), of 8 x 5");
  CHECK(other.x == Approx((1.25 - 4) / 8).margin(1e-5));
  CHECK(other.y == Approx((2.5 - 2.75) / 8).margin(1e-5));
}

TEST_CASE("the middle of the picture is the forward axis, at every size") {
  // Axes with short decimals: 0.48^2 + 0.6^2 + 0.64^2 = 1, and so on.
  const Camera slanted{
      {5, 6, 7}, {0.8f, 0, -0.6f}, {-0.36f, 0.8f, -0.48f}, {0.48f, 0.6f, 0.64f}, 1.2f};
  REQUIRE(is_sound(slanted));
  for (const ivec2 size : {ivec2{900, 720}, {901, 721}, {1, 1}, {1, 3}, {9, 4}}) {
    const ivec2 pixel = size / 2;
    const vec2 offset = vec2(size) / 2.0f - vec2(pixel);
    const Ray ray = camera_ray(slanted, pixel, offset, size.x, size.y);
    INFO("picture of " << size.x << " x " << size.y);
    CHECK(ray.origin == slanted.position);
    CHECK(same(Direction{ray.direction}, Direction{slanted.forward}));
  }
}

TEST_CASE("every direction is unit") {
  const dvec3 d(camera_ray(straight, {0, 0}, {0, 0}, 8, 5).direction);
  // The window's corner is at (-1/2, 5/16, 1): 1.16 from the pinhole.
  lt::diagnose(!is_near(glm::length(d), std::sqrt(0.25 + 25.0 / 256 + 1)), "direction-not-unit",
               gave("To the corner of an 8 x 5 picture the direction's length", glm::length(d), 1));
  CHECK(glm::length(d) == Approx(1).epsilon(1e-6));
}

TEST_CASE("the four corners of a picture of 900 x 720 at 72 degrees") {
  // tan 36 degrees, from the regular pentagon.
  const double half_width = std::sqrt(5 - 2 * std::sqrt(5.0));
  const double half_height = half_width * 720 / 900;
  Camera camera = straight;
  camera.field_of_view = static_cast<float>(0.4 * std::acos(-1.0));
  const auto ray = [&](ivec2 pixel, vec2 offset) {
    return Direction{camera_ray(camera, pixel, offset, 900, 720).direction};
  };
  CHECK(same(ray({0, 0}, {0, 0}), unit({-half_width, half_height, 1})));
  CHECK(same(ray({899, 0}, {1, 0}), unit({half_width, half_height, 1})));
  CHECK(same(ray({0, 719}, {0, 1}), unit({-half_width, -half_height, 1})));
  CHECK(same(ray({899, 719}, {1, 1}), unit({half_width, -half_height, 1})));
  std::ostringstream text;
  text.precision(3);
  text << "at 72 degrees from left to right, the corners look "
       << glm::degrees(std::acos(ray({0, 0}, {0, 0}).v.z)) << " degrees aside";
  lt::measured(text.str());
}

TEST_CASE("random cameras aim through every point of their pictures") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 60; ++i) {
      const Camera camera = random_camera(random);
      const int width = 3 + static_cast<int>(random.uniform(0, 1000));
      const int height = static_cast<int>(random.uniform(1.0 / 3, 3) * width);
      const double share_x = random.uniform();
      const double share_y = random.uniform();
      const ivec2 pixel(share_x * width, share_y * height);
      const vec2 offset = vec2(dvec2(share_x * width, share_y * height) - dvec2(pixel));
      // As shares of the picture's width, and half the width is the tangent of half the angle.
      const double tangent = std::tan(static_cast<double>(camera.field_of_view) / 2);
      const double x = (2 * share_x - 1) * tangent;
      const double y = (1 - 2 * share_y) * tangent * height / width;
      const Direction expected =
          unit(x * dvec3(camera.right) + y * dvec3(camera.up) + dvec3(camera.forward));
      const Ray ray = camera_ray(camera, pixel, offset, width, height);
      INFO("pixel (" << pixel.x << ", " << pixel.y << ") + " << shown(dvec3(offset, 0)) << " of "
                     << width << " x " << height << ", field of view " << camera.field_of_view);
      REQUIRE(ray.origin == camera.position);
      REQUIRE(same(Direction{ray.direction}, expected));
    }
  }
}
