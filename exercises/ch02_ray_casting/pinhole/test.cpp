#include "api.hpp"

#include <cmath>
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
using lt::close_to;

// Aiming between corners of the window adds numbers of up to 8 here (half its width 2, half its
// height 6), in some five steps that each round by 2^-24 of that: 2.4e-6. Four times as much is
// room for other orders.
constexpr double tolerance = 1e-5;

lt::CloseTo<dvec3> near(dvec3 v) {
  return close_to(v, tolerance);
}

lt::CloseTo<double> near(double value) {
  return close_to(value, tolerance);
}

std::string shown(dvec3 v) {
  std::ostringstream text;
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

std::string shown(double value) {
  return std::to_string(value);
}

template <class T>
std::string gave(const std::string& what, T value, T expected) {
  return what + " is " + shown(value) + " and should be " + shown(expected) + ".";
}

constexpr dvec3 x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

// Looks along +z. Half of its field of view has the tangent 1/2, so that the window at distance 1
// is 1 wide; all of it has the tangent 2 (1/2) / (1 - 1/4) = 4/3.
const Camera straight{{0, 0, 0}, x_axis, y_axis, z_axis, 2.0f * std::atan(0.5f)};

// Where the ray through a point of a pixel pierces that window, in a picture of 8 x 5; nowhere
// (NaN) if it leaves backwards.
dvec2 on_window(ivec2 pixel, vec2 offset = vec2(0.5f)) {
  const dvec3 d(camera_ray(straight, pixel, offset, 8, 5).direction);
  return d.z > 0 ? dvec2(d) / d.z : dvec2(std::nan(""));
}

// One column to the right moves x by this, and one row down moves y.
dvec2 step() {
  const dvec2 start = on_window({4, 1});
  return {on_window({5, 1}).x - start.x, on_window({4, 2}).y - start.y};
}

}  // namespace

TEST_CASE("a camera that looks along +z has the axes of the world") {
  const Camera camera = look_at({1, 2, 3}, {1, 2, 8}, y_axis, 1.0f);
  const dvec3 right = camera.right, up = camera.up, forward = camera.forward;
  lt::diagnose(!(forward == near(-z_axis)), "looks-away",
               gave("For a target along +z, forward", forward, z_axis));
  lt::diagnose(!(forward == near(z_axis) && up == near(y_axis) && right == near(-x_axis)),
               "mirrored", gave("For a target along +z, right", right, x_axis));
  lt::diagnose(!(forward == near(z_axis) && up == near(-y_axis) && right == near(-x_axis)),
               "rolled-over", gave("For a target along +z, up", up, y_axis));
  CHECK(dvec3(camera.forward) == near(z_axis));
  CHECK(dvec3(camera.right) == near(x_axis));
  CHECK(dvec3(camera.up) == near(y_axis));
  CHECK(camera.position == vec3(1, 2, 3));
  CHECK(camera.field_of_view == 1.0f);
}

TEST_CASE("a camera that looks down keeps its horizon level and its axes perpendicular") {
  // 3 down and 4 ahead: the line of sight is 5 long.
  const Camera camera = look_at({0, 3, 0}, {0, 0, 4}, y_axis, 1.0f);
  const dvec3 right = camera.right, up = camera.up, forward = camera.forward;
  const bool is_forward_right = forward == near(dvec3(0, -0.6, 0.8));
  const std::string what = "Looking down from (0, 3, 0) to (0, 0, 4), ";
  lt::diagnose(!(is_forward_right && up == near(y_axis)), "world-up-kept",
               gave(what + "up", up, dvec3(0, 0.8, 0.6)));
  // The cosine of the slope is 0.8, which is what y x forward is long.
  const double shortest = std::fmin(glm::length(right), glm::length(up));
  lt::diagnose(!(is_forward_right && shortest == near(0.8)), "axis-not-unit",
               gave(what + "the length of an axis", shortest, 1.0));
  CHECK(dvec3(camera.forward) == near(dvec3(0, -0.6, 0.8)));
  CHECK(dvec3(camera.right) == near(x_axis));
  CHECK(dvec3(camera.up) == near(dvec3(0, 0.8, 0.6)));
}

TEST_CASE("rays leave forward, in directions that do not depend on where the camera stands") {
  const dvec3 here = camera_ray(straight, {1, 1}, {0.5f, 0.5f}, 8, 5).direction;
  Camera moved = straight;
  moved.position = {1, 2, 3};
  const Ray there = camera_ray(moved, {1, 1}, {0.5f, 0.5f}, 8, 5);
  lt::diagnose(dvec3(there.direction) == near(here), "position-added",
               "Through one and the same pixel, the direction is " + shown(here) +
                   " for a camera at 0 and " + shown(there.direction) + " for one at (1, 2, 3).");
  CHECK(there.origin == moved.position);
  CHECK(here.z > 0);
}

TEST_CASE("columns go to the right, rows go downward") {
  const dvec2 seen = step();
  lt::diagnose(!(seen.y > 0), "rows-upward",
               gave("One row down, at distance 1, the change of y", seen.y, -0.125));
  CHECK(seen.x > 0);
  CHECK(seen.y < 0);
  CHECK(on_window({0, 0}).x < 0);
  CHECK(on_window({0, 0}).y > 0);
}

TEST_CASE("the field of view reaches from the left edge to the right, and pixels are square") {
  // 8 columns share a window that is 1 wide. The tangent of the whole angle makes it 8/3 wide; an
  // angle from top to bottom makes 5 rows share it.
  const double across = step().x;
  const std::string what = "In a picture of 8 x 5, at distance 1, a pixel's width";
  lt::diagnose(!(across == near(1.0 / 3)), "field-not-halved", gave(what, across, 0.125));
  lt::diagnose(!(across == near(0.2)), "vertical-field", gave(what, across, 0.125));
  const double ratio = std::abs(step().y) / across;
  // 5 rows share the same window as 8 columns.
  lt::diagnose(!(ratio == near(8.0 / 5)), "aspect-forgotten",
               gave("In a picture of 8 x 5, a pixel's height over its width", ratio, 1.0));
  CHECK(across == near(0.125));
  CHECK(ratio == near(1.0));
}

TEST_CASE("the offset says where in the pixel") {
  const double middle = 4 + on_window({1, 2}).x / step().x;  // from the left edge
  const dvec2 other = on_window({1, 2}, {0.25f, 0.75f});
  const bool is_ignored = glm::distance(other, on_window({1, 2})) < 1e-6;
  const bool is_step_right = step().x == near(0.125);
  const std::string what = "For pixel (1, 2) and offset (0.5, 0.5), x in pixels from the left edge";
  lt::diagnose(!(is_step_right && is_ignored && middle == near(1.0)), "pixel-corner",
               gave(what, middle, 1.5));
  lt::diagnose(!(is_step_right && !is_ignored && middle == near(2.0)), "half-added-twice",
               gave(what, middle, 1.5));
  const double middle_row = on_window({1, 2}).y;
  lt::diagnose(!(is_step_right && middle == near(1.5) && middle_row == near(-0.0625)),
               "whole-number-half",
               gave("In a picture of 5 rows, y at the middle of row 2", middle_row, 0.0));
  CHECK(middle == near(1.5));
  CHECK(middle_row == near(0.0));
  INFO("pixel (1, 2), offset (0.25, 0.75), of 8 x 5");
  CHECK(other.x == near((1.25 - 4) / 8));
  CHECK(other.y == near((2.5 - 2.75) / 8));
}

TEST_CASE("the four corners of a picture of 900 x 720 at 72 degrees") {
  // tan 36 degrees, from the regular pentagon.
  const double half_width = std::sqrt(5 - 2 * std::sqrt(5.0));
  const double half_height = half_width * 720 / 900;
  Camera camera = straight;
  camera.field_of_view = static_cast<float>(0.4 * std::acos(-1.0));
  const auto ray = [&](ivec2 pixel, vec2 offset) {
    return dvec3(camera_ray(camera, pixel, offset, 900, 720).direction);
  };
  // The window's corner is 1.366 from the pinhole.
  const dvec3 corner(-half_width, half_height, 1);
  const double length = glm::length(ray({0, 0}, {0, 0}));
  lt::diagnose(!(length == near(glm::length(corner))), "direction-not-unit",
               gave("To the corner of the picture, the direction's length", length, 1.0));
  CHECK(ray({0, 0}, {0, 0}) == near(glm::normalize(corner)));
  CHECK(ray({899, 0}, {1, 0}) == near(glm::normalize(dvec3{half_width, half_height, 1})));
  CHECK(ray({0, 719}, {0, 1}) == near(glm::normalize(dvec3{-half_width, -half_height, 1})));
  CHECK(ray({899, 719}, {1, 1}) == near(glm::normalize(dvec3{half_width, -half_height, 1})));
  const double aside = glm::degrees(std::acos(ray({0, 0}, {0, 0}).z));
  lt::measured("at 72 degrees from left to right, the corners look " +
               std::to_string(std::lround(aside)) + " degrees aside");
}

TEST_CASE("the middle of the picture is the forward axis, at every size") {
  const Camera slanted = look_at({5, 6, 7}, {1, 2, 9}, y_axis, 1.2f);
  for (const ivec2 size : {ivec2{900, 720}, {901, 721}, {1, 1}, {1, 3}, {9, 4}}) {
    const ivec2 pixel = size / 2;
    const vec2 offset = vec2(size) / 2.0f - vec2(pixel);
    const Ray ray = camera_ray(slanted, pixel, offset, size.x, size.y);
    INFO("picture of " << size.x << " x " << size.y);
    CHECK(ray.origin == slanted.position);
    CHECK(dvec3(ray.direction) == near(slanted.forward));
  }
}

TEST_CASE("random cameras see their target, stand upright and aim through every point") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 60; ++i) {
      const vec3 position(10.0 * random.direction());
      const vec3 target(dvec3(position) + random.uniform(0.5, 20) * random.direction());
      const vec3 up(random.direction());
      const dvec3 line_of_sight = glm::normalize(dvec3(target) - dvec3(position));
      if (glm::length(glm::cross(dvec3(up), line_of_sight)) < 0.3) continue;
      const auto angle = static_cast<float>(random.uniform(0.05, 2.2));
      const Camera camera = look_at(position, target, up, angle);
      const dmat3 axes(camera.right, camera.up, camera.forward);
      INFO("position " << shown(position) << ", target " << shown(target) << ", up " << shown(up));
      REQUIRE(axes[2] == near(line_of_sight));
      REQUIRE(glm::length(axes[0]) == near(1.0));
      REQUIRE(glm::dot(axes[0], axes[2]) == near(0.0));
      REQUIRE(glm::dot(axes[0], dvec3(up)) == near(0.0));  // up leans neither left nor right
      REQUIRE(axes[1] == near(glm::cross(axes[2], axes[0])));
      REQUIRE(glm::determinant(axes) == near(1.0));
      REQUIRE(glm::dot(axes[1], dvec3(up)) > 0);

      const int width = 3 + static_cast<int>(random.uniform(0, 1000));
      const int height = static_cast<int>(random.uniform(1.0 / 3, 3) * width);
      const double film_x = random.uniform(0, width);
      const double film_y = random.uniform(0, height);
      const ivec2 pixel(film_x, film_y);
      const vec2 offset = vec2(dvec2(film_x, film_y) - dvec2(pixel));
      const Ray ray = camera_ray(camera, pixel, offset, width, height);
      // Half the width is the tangent of half the angle.
      const double size = 2 * std::tan(static_cast<double>(angle) / 2) / width;
      const dvec3 aim((film_x - width / 2.0) * size, (height / 2.0 - film_y) * size, 1);
      INFO("pixel (" << pixel.x << ", " << pixel.y << ") + " << shown(dvec3(offset, 0)) << " of "
                     << width << " x " << height << ", field of view " << angle);
      REQUIRE(ray.origin == position);
      REQUIRE(dvec3(ray.direction) == near(glm::normalize(axes * aim)));
    }
  }
}
