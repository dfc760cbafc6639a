#include "ch02_ray_casting/three_sphere_room.hpp"

#include <numbers>

#include "ch02_ray_casting/surface_point.hpp"
#include "ch02_ray_casting/tests/reference.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// How far along the ray from inside the box 0..3 its exit lies, and through which face.
struct Exit {
  float t = infinity;
  int axis = 0;
  bool is_high = false;  ///< through the face at 3, not at 0
};

Exit exit_of(const Ray& ray) {
  Exit exit;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_high = ray.direction[axis] > 0.0f;
    const float t = ((is_high ? 3.0f : 0.0f) - ray.origin[axis]) / ray.direction[axis];
    if (t >= 0.0f && t < exit.t) exit = {t, axis, is_high};
  }
  return exit;
}

// The first number of the face that a ray leaves through; the front has none.
int object_of(const Exit& exit) {
  if (exit.axis == 0) return exit.is_high ? room::east_wall : room::west_wall;
  if (exit.axis == 1) return exit.is_high ? room::ceiling : room::floor;
  return exit.is_high ? static_cast<int>(room::north_wall) : -1;
}

vec3 point_in_room(RandomCases& random) {
  const float x = random.uniform(0.01f, 2.99f);
  const float y = random.uniform(0.01f, 2.99f);
  return {x, y, random.uniform(0.01f, 2.99f)};
}

}  // namespace

TEST_CASE("room: spheres and ground have the thesis' numbers") {
  const Scene scene = three_sphere_room();
  REQUIRE(scene.object_count() == 13);
  CHECK(scene.spheres[room::light].center == vec3(1.5f, 3.0f, 1.5f));
  CHECK(scene.spheres[room::light].radius == 0.5f);
  CHECK(scene.spheres[room::clear_sphere].center == vec3(1.5f, 0.7f, 1.5f));
  CHECK(scene.spheres[room::clear_sphere].radius == 0.7f);
  CHECK(scene.spheres[room::gold_sphere].center == vec3(0.5f, 0.45f, 2.1f));
  CHECK(scene.spheres[room::gold_sphere].radius == 0.45f);
  CHECK(scene.spheres[room::green_sphere].center == vec3(2.5f, 0.45f, 2.1f));
  CHECK(scene.spheres[room::green_sphere].radius == 0.45f);
  REQUIRE(scene.grounds.size() == 1);
  CHECK(scene.grounds[0].level == 0.0f);
}

TEST_CASE("room: the cameras have the thesis' numbers") {
  for (const Camera& camera : {room_camera_near(), room_camera_far()}) {
    CHECK(camera.field_of_view == Approx(0.2 * 2 * std::numbers::pi).epsilon(1e-6));
    CHECK(camera.forward == vec3(0, 0, 1));
    CHECK(camera.up == vec3(0, 1, 0));
  }
  CHECK(room_camera_near().position == vec3(1.5f, 0.5f, -0.5f));
  CHECK(room_camera_far().position == vec3(1.5f, 1.5f, -2.064f));
}

TEST_CASE("room: each wall is two triangles that fill a face of 3 x 3 m") {
  const Scene scene = three_sphere_room();
  REQUIRE(scene.triangles.size() == 8);
  const auto first = static_cast<std::size_t>(room::north_wall);
  REQUIRE(first == scene.spheres.size());
  for (std::size_t wall = 0; wall < 4; ++wall) {
    double area = 0;
    vec3 low(infinity);
    vec3 high(-infinity);
    for (const std::size_t i : {2 * wall, 2 * wall + 1}) {
      const Triangle& t = scene.triangles[i];
      area += length(cross(t.corner(1) - t.corner(0), t.corner(2) - t.corner(0))) / 2;
      for (int c = 0; c < 3; ++c) {
        low = glm::min(low, t.corner(c));
        high = glm::max(high, t.corner(c));
      }
    }
    CHECK(area == 9.0);
    const vec3 extent = high - low;
    CHECK(extent.x + extent.y + extent.z == 6.0f);  // 3 + 3 + 0
  }
}

TEST_CASE("room: all normals of walls and ceiling and ground point into the room") {
  const Scene scene = three_sphere_room();
  const vec3 middle(1.5f);
  for (const Triangle& triangle : scene.triangles)
    CHECK(dot(triangle.normal(), middle - triangle.corner(0)) == Approx(1.5));
  CHECK(point_on(scene.grounds[0], {1, 0, 1}).normal == vec3(0, 1, 0));
}

TEST_CASE("room: the names of the objects are their numbers") {
  const Scene scene = three_sphere_room();
  // From a free place straight at each one.
  const auto object_at = [&](vec3 from, vec3 to) {
    return closest_hit(scene, Ray{from, normalize(to - from)})->object;
  };
  const vec3 from{1.5f, 1.8f, 0.3f};
  CHECK(object_at(from, {1.5f, 3.0f, 1.5f}) == room::light);
  CHECK(object_at(from, {1.5f, 0.7f, 1.5f}) == room::clear_sphere);
  CHECK(object_at({0.5f, 1.8f, 0.3f}, {0.5f, 0.45f, 2.1f}) == room::gold_sphere);
  CHECK(object_at({2.5f, 1.8f, 0.3f}, {2.5f, 0.45f, 2.1f}) == room::green_sphere);
  CHECK(object_at(from, {0.5f, 0.0f, 0.5f}) == room::floor);
  // Both triangles of each wall: beside the diagonal from its top left to its bottom right.
  CHECK(object_at(from, {2.5f, 2.0f, 3.0f}) == room::north_wall);
  CHECK(object_at(from, {0.5f, 1.5f, 3.0f}) == room::north_wall + 1);
  CHECK(object_at(from, {0.0f, 2.5f, 2.0f}) == room::west_wall);
  CHECK(object_at(from, {0.0f, 0.5f, 0.5f}) == room::west_wall + 1);
  CHECK(object_at(from, {3.0f, 2.5f, 1.0f}) == room::east_wall);
  CHECK(object_at(from, {3.0f, 1.5f, 2.5f}) == room::east_wall + 1);
  CHECK(object_at(from, {2.5f, 3.0f, 0.5f}) == room::ceiling);
  CHECK(object_at(from, {0.2f, 3.0f, 0.5f}) == room::ceiling + 1);
}

TEST_CASE("room: every ray from inside hits the wall that it would leave through or a sphere") {
  const Scene scene = three_sphere_room();
  RandomCases random(14);
  int through_front = 0;
  for (int i = 0; i < 300'000; ++i) {
    const Ray ray{point_in_room(random), random.direction()};
    const Exit exit = exit_of(ray);
    const auto hit = closest_hit(scene, ray);
    const int expected = object_of(exit);
    if (expected < 0) {  // the open front: the ground goes on outside, the sky is empty
      ++through_front;
      const bool leaves = !hit || hit->object < scene.spheres.size() || hit->object == room::floor;
      REQUIRE(leaves);
      continue;
    }
    CAPTURE(i, ray.origin, ray.direction);
    REQUIRE(hit);
    if (hit->object < scene.spheres.size()) {
      REQUIRE(hit->t < exit.t + 1e-5f);
      continue;
    }
    REQUIRE(hit->t == Approx(exit.t).epsilon(1e-5));
    const bool is_near_edge = [&] {  // within rounding of two faces
      const vec3 p = ray.at(exit.t);
      int faces = 0;
      for (int axis = 0; axis < 3; ++axis)
        faces += p[axis] < 1e-5f || p[axis] > 3.0f - 1e-5f;
      return faces > 1;
    }();
    if (is_near_edge) continue;
    const int found = static_cast<int>(hit->object);
    REQUIRE((found == expected || (found == expected + 1 && expected != room::floor)));
  }
  CHECK(through_front > 10'000);
}

TEST_CASE("room: no ray slips out between two walls or between wall and ground") {
  const Scene scene = three_sphere_room();
  RandomCases random(15);
  for (int i = 0; i < 200'000; ++i) {
    // Onto one of the edges of the box, but not those of the open front.
    vec3 target = point_in_room(random);
    const int edge = i % 8;
    if (edge < 4) {
      target.x = edge & 1 ? 3.0f : 0.0f;
      target.y = edge & 2 ? 3.0f : 0.0f;
    } else {
      target.z = 3.0f;
      (edge & 1 ? target.x : target.y) = edge & 2 ? 3.0f : 0.0f;
    }
    const vec3 origin = point_in_room(random);
    REQUIRE(closest_hit(scene, Ray{origin, normalize(target - origin)}));
  }
}

TEST_CASE("room: from the far camera the front of the room just fills the width") {
  // 1.5 / tan 36 degrees = 2.0646; at 2.064 m the picture is a millimetre narrower than the room.
  const Scene scene = three_sphere_room();
  const Camera camera = room_camera_far();
  for (const vec2 film : {vec2{0.0f, 360.0f}, vec2{900.0f, 360.0f}}) {
    const Ray ray = camera_ray(camera, film, 900, 720);
    const vec3 at_front = ray.at(2.064f / ray.direction.z);
    CHECK(std::abs(at_front.x - 1.5f) == Approx(1.5).margin(0.001));
    CHECK(std::abs(at_front.x - 1.5f) < 1.5f);
    CHECK(closest_hit(scene, ray)->object != room::floor);
  }
}
