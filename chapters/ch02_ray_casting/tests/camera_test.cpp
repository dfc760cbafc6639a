#include "ch02_ray_casting/camera.hpp"

#include "ch02_ray_casting/tests/reference.hpp"
#include "ch02_ray_casting/three_sphere_room.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// tan 36 degrees, from the regular pentagon: sqrt(5 - 2 sqrt 5).
const double tan36 = std::sqrt(5 - 2 * std::sqrt(5.0));

void check_axes(const Camera& camera) {
  const mat3 axes(camera.right, camera.up, camera.forward);
  const mat3 products = glm::transpose(axes) * axes;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      REQUIRE(products[i][j] == Approx(i == j ? 1 : 0).margin(1e-6));
  REQUIRE(glm::determinant(axes) == Approx(1).epsilon(1e-6));
}

}  // namespace

TEST_CASE("camera: the four corners of a 900 x 720 picture at 72 degrees") {
  const Camera camera;
  const double half_width = tan36;
  const double half_height = tan36 * 720 / 900;
  const double distance = std::sqrt(half_width * half_width + half_height * half_height + 1);
  for (const double right : {0.0, 1.0})
    for (const double down : {0.0, 1.0}) {
      const Ray ray = camera_ray(camera, vec2(900 * right, 720 * down), 900, 720);
      CHECK(ray.direction.x == Approx((2 * right - 1) * half_width / distance).epsilon(1e-6));
      CHECK(ray.direction.y == Approx((1 - 2 * down) * half_height / distance).epsilon(1e-6));
      CHECK(ray.direction.z == Approx(1 / distance).epsilon(1e-6));
    }
}

TEST_CASE("camera: the middle of the picture is straight ahead at every size") {
  const Camera camera = look_at({1, 2, 3}, {4, 6, 3});
  for (const ivec2 size : {ivec2{900, 720}, ivec2{901, 721}, ivec2{1, 1}, ivec2{1, 500}}) {
    const Ray ray = camera_ray(camera, vec2(size) / 2.0f, size.x, size.y);
    CHECK(ray.origin == camera.position);
    CHECK(length(ray.direction - camera.forward) < 1e-6f);
  }
}

TEST_CASE("camera: the middle pixel of an odd width looks straight ahead without rounding") {
  for (const int width : {1, 3, 321, 901})
    CHECK(camera_ray(Camera{}, {static_cast<float>(width / 2) + 0.5f, 0.5f}, width, 720)
              .direction.x == 0.0f);
}

TEST_CASE("camera: columns go right and rows go down") {
  const Camera camera;
  const Ray top_left = camera_ray(camera, {10.5f, 10.5f}, 900, 720);
  CHECK(top_left.direction.x < 0.0f);
  CHECK(top_left.direction.y > 0.0f);
  CHECK(camera_ray(camera, {11.5f, 10.5f}, 900, 720).direction.x > top_left.direction.x);
  CHECK(camera_ray(camera, {10.5f, 11.5f}, 900, 720).direction.y < top_left.direction.y);
}

TEST_CASE("camera: left and right edge are the field of view apart") {
  for (const float degrees : {1.0f, 36.0f, 72.0f, 120.0f, 170.0f}) {
    Camera camera;
    camera.field_of_view = radians(degrees);
    const Ray left = camera_ray(camera, {0, 360}, 900, 720);
    const Ray right = camera_ray(camera, {900, 360}, 900, 720);
    const double angle = 2 * std::atan2(length(right.direction - left.direction) / 2,
                                        length(right.direction + left.direction) / 2);
    CHECK(glm::degrees(angle) == Approx(degrees).epsilon(1e-5));
  }
}

TEST_CASE("camera: pixels are square whatever the shape of the picture") {
  for (const ivec2 size : {ivec2{900, 720}, ivec2{100, 1000}, ivec2{1000, 10}}) {
    const vec2 middle = vec2(size) / 2.0f;
    const vec3 ahead = camera_ray(Camera{}, middle, size.x, size.y).direction;
    const vec3 right = camera_ray(Camera{}, middle + vec2{1, 0}, size.x, size.y).direction;
    const vec3 down = camera_ray(Camera{}, middle + vec2{0, 1}, size.x, size.y).direction;
    CHECK(length(right - ahead) == Approx(length(down - ahead)).epsilon(1e-3));
  }
}

TEST_CASE("camera: every ray is of unit length and starts in the pinhole") {
  RandomCases random(11);
  const Camera camera = look_at({1, 2, 3}, {-4, 0, 7});
  for (int i = 0; i < 10'000; ++i) {
    const vec2 film{random.uniform(0, 900), random.uniform(0, 720)};
    const Ray ray = camera_ray(camera, film, 900, 720);
    REQUIRE(ray.origin == camera.position);
    REQUIRE(length(ray.direction) == Approx(1).epsilon(2e-7));
  }
}

TEST_CASE("camera: look_at has perpendicular unit axes of determinant 1 and sees its target") {
  RandomCases random(12);
  for (int i = 0; i < 10'000; ++i) {
    const vec3 position = random.point_within(10.0f);
    const vec3 line_of_sight = random.direction();
    if (std::abs(line_of_sight.y) > 0.99f) continue;  // along `up`
    const Camera camera = look_at(position, position + 5.0f * line_of_sight);
    check_axes(camera);
    REQUIRE(length(camera.forward - line_of_sight) < 1e-5f);
    REQUIRE(camera.up.y > 0.0f);
    REQUIRE(camera.right.y == Approx(0).margin(1e-6));  // the horizon is level
  }
}

TEST_CASE("camera: looking along +z is the camera that is not turned") {
  const Camera camera = look_at({1, 2, 3}, {1, 2, 8});
  CHECK(camera.right == Camera{}.right);
  CHECK(camera.up == Camera{}.up);
  CHECK(camera.forward == Camera{}.forward);
}

TEST_CASE("camera: look_at and oriented agree") {
  RandomCases random(13);
  for (int i = 0; i < 10'000; ++i) {
    // Turn by `yaw` about the vertical, then tilt: forward from sines and cosines.
    const float yaw = random.uniform(-3.1f, 3.1f);
    const float tilt = random.uniform(-1.4f, 1.4f);
    const glm::quat turn = glm::angleAxis(yaw, vec3{0, 1, 0}) * glm::angleAxis(tilt, vec3{1, 0, 0});
    const vec3 forward{std::sin(yaw) * std::cos(tilt), -std::sin(tilt),
                       std::cos(yaw) * std::cos(tilt)};
    const vec3 position = random.point_within(5.0f);
    const Camera by_turn = oriented(position, turn);
    const Camera by_target = look_at(position, position + forward);
    check_axes(by_turn);
    REQUIRE(by_turn.position == position);
    REQUIRE(length(by_turn.forward - by_target.forward) < 1e-5f);
    REQUIRE(length(by_turn.up - by_target.up) < 1e-5f);
    REQUIRE(length(by_turn.right - by_target.right) < 1e-5f);
  }
}
