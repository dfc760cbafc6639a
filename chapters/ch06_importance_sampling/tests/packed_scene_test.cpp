#include "ch06_importance_sampling/packed_scene.hpp"

#include "ch05_rendering_equation/lit_room.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/exercise.hpp"

using namespace lt;

namespace {

vec3 point_in(TestRandom& random, double side) {
  const double x = random.uniform(-side, side);
  const double y = random.uniform(-side, side);
  const double z = random.uniform(-side, side);
  return {x, y, z};
}

// How many of the rays' hits differ in any digit.
int differences(const TexturedScene& scene, const std::vector<Ray>& rays) {
  const PackedScene packed(scene);
  int found = 0;
  for (const Ray& ray : rays) {
    const auto a = closest_hit(scene, ray);
    const auto b = closest_hit(packed, ray);
    if (a.has_value() != b.has_value() || (a && (a->t != b->t || a->object != b->object))) ++found;
  }
  return found;
}

// Anywhere in any direction; and what is special: through the world's origin, along the axes, with
// zeros of both signs, from a point on the ground.
std::vector<Ray> rays_for(TestRandom& random, int count, double side) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    Ray ray{point_in(random, side), random.direction()};
    const vec3 zeros(i & 8 ? 0.0f : -0.0f);
    if (i % 8 == 1) ray.direction = -normalize(ray.origin);
    if (i % 8 == 2) ray = {vec3(0.0f), ray.direction};
    if (i % 8 == 3) ray.direction = vec3(zeros.x, i & 16 ? 1.0f : -1.0f, zeros.z);
    if (i % 8 == 4) ray.direction = normalize(vec3(ray.direction.x, zeros.y, ray.direction.z));
    if (i % 8 == 5) ray.origin = glm::round(ray.origin);
    if (i % 8 == 6) ray.origin.y = 0.0f;
    rays.push_back(ray);
  }
  return rays;
}

TexturedScene random_scene(TestRandom& random, int spheres, int triangles, int grounds) {
  Scene scene;
  for (int i = 0; i < spheres; ++i)
    scene.spheres.push_back(
        {point_in(random, 4), static_cast<float>(random.uniform(0.05, i % 5 ? 1 : 6))});
  for (int i = 0; i < triangles; ++i) {
    const vec3 a = point_in(random, 4);
    const vec3 b = point_in(random, 4);
    const vec3 c = point_in(random, 4);
    scene.triangles.emplace_back(a, b, c);
  }
  for (int i = 0; i < grounds; ++i)
    scene.grounds.push_back({static_cast<float>(random.uniform(-3, 3))});
  return TexturedScene(scene);
}

}  // namespace

TEST_CASE("packed scene: the room's hits are the list's, digit for digit") {
  TestRandom random(1);
  const TexturedScene room(three_sphere_room());
  std::vector<Ray> rays = rays_for(random, 100'000, 3);
  for (Ray& ray : rays)
    ray.origin += vec3(1.5f);
  CHECK(differences(room, rays) == 0);

  std::vector<Ray> camera_rays;
  for (int y = 0; y < 72; ++y)
    for (int x = 0; x < 90; ++x)
      for (const vec2 within : {vec2(0.0f), vec2(0.5f)})
        camera_rays.push_back(camera_ray(room_camera_far(), vec2(x, y) + within, 90, 72));
  CHECK(differences(room, camera_rays) == 0);
}

TEST_CASE("packed scene: rays that leave surfaces hit the same, digit for digit") {
  TestRandom random(2);
  const TexturedScene room(three_sphere_room());
  std::vector<Ray> leaving;
  for (int i = 0; i < 50'000; ++i) {
    const vec2 film(random.uniform(0, 90), random.uniform(0, 72));
    const Ray ray = camera_ray(room_camera_far(), film, 90, 72);
    if (const auto hit = closest_hit(room, ray))
      leaving.push_back(leave(surface_point(room.shapes, ray, *hit), random.direction()));
  }
  REQUIRE(leaving.size() > 40'000);
  CHECK(differences(room, leaving) == 0);
}

TEST_CASE("packed scene: scenes of 0 to 40 spheres and triangles, digit for digit") {
  TestRandom random(3);
  for (int spheres = 0; spheres <= 40; spheres += spheres < 18 ? 1 : 11)
    for (const int triangles : {0, 1, 7, 8, 9, 16, 25, 40}) {
      const TexturedScene scene = random_scene(random, spheres, triangles, spheres % 3);
      CAPTURE(spheres, triangles);
      REQUIRE(differences(scene, rays_for(random, 800, 5)) == 0);
    }
}

TEST_CASE("packed scene: of two objects in the same place the first one wins, as in the list") {
  Scene scene;
  scene.spheres = {{{0, 0, 5}, 1.0f}, {{0, 0, 5}, 1.0f}};
  for (int i = 0; i < 9; ++i)
    scene.triangles.emplace_back(vec3(-1, -1, 4), vec3(-1, 1, 4), vec3(1, 0, 4));
  scene.grounds = {{0.0f}, {0.0f}};
  const TexturedScene list(scene);
  const PackedScene packed(list);
  const auto object = [&](const Ray& ray) { return closest_hit(packed, ray)->object; };
  CHECK(object({{0, 0, 0}, {0, 0, 1}}) == 0u);  // sphere and triangles at exactly 4
  CHECK(object({{-0.9f, 0, 0}, {0, 0, 1}}) == 2u);
  CHECK(object({{3, 1, 0}, {0, -1, 0}}) == 11u);
  TestRandom random(4);
  CHECK(differences(list, rays_for(random, 10'000, 6)) == 0);
}

TEST_CASE("packed scene: lanes without a shape are never hit") {
  TestRandom random(5);
  const TexturedScene nothing{Scene{}};
  CHECK(differences(nothing, rays_for(random, 1000, 3)) == 0);
  Scene one;
  one.spheres = {{{100, 0, 0}, 1.0f}};
  one.triangles.emplace_back(vec3(100, 0, 0), vec3(100, 1, 0), vec3(100, 0, 1));
  const TexturedScene far_away(one);
  std::vector<Ray> through_origin;  // where an empty lane's zeros are
  for (const Ray& ray : rays_for(random, 10'000, 3))
    through_origin.push_back({-3.0f * ray.direction, ray.direction});
  CHECK(differences(far_away, through_origin) == 0);
}

TEST_CASE("packed scene: its surfaces and its background are the list's") {
  const TexturedScene room = matt_room(16);
  const PackedScene packed(room);
  const Ray ray = camera_ray(room_camera_far(), {30.0f, 40.0f}, 90, 72);
  const auto hit = closest_hit(packed, ray);
  REQUIRE(hit);
  const Surface a = surface_at(room, ray, *hit);
  const Surface b = surface_at(packed, ray, *hit);
  CHECK(a.frame.normal == b.frame.normal);
  CHECK(a.material.tint == b.material.tint);
  CHECK(a.point.position == b.point.position);
  CHECK(background(packed, {0, 0, -1}) == background(room, {0, 0, -1}));
  static_assert(Traceable<PackedScene>);
}
