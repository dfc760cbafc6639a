#include "ch02_ray_casting/surface_point.hpp"

#include "ch02_ray_casting/tests/reference.hpp"
#include "ch02_ray_casting/three_sphere_room.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// Signed height above the true surface, in double.
double height(const Sphere& sphere, vec3 p) {
  return length(glm::dvec3(p) - glm::dvec3(sphere.center)) - sphere.radius;
}

double height(const Triangle& triangle, vec3 p) {
  const glm::dvec3 p0(triangle.corner(0));
  const glm::dvec3 n =
      cross(glm::dvec3(triangle.corner(1)) - p0, glm::dvec3(triangle.corner(2)) - p0);
  return dot(normalize(n), glm::dvec3(p) - p0);
}

Sphere random_sphere(RandomCases& random) {
  return {random.point_within(random.any_size(-2.0f, 3.0f)), random.any_size(-2.0f, 2.0f)};
}

// A ray from outside that hits the sphere, and where.
struct SphereHit {
  Ray ray;
  SurfacePoint point;
};

std::optional<SphereHit> hit_sphere(RandomCases& random, const Sphere& sphere) {
  const vec3 origin = sphere.center + 3.0f * sphere.radius * random.direction();
  const vec3 aim = sphere.center + random.point_within(0.7f * sphere.radius);
  const Ray ray{origin, normalize(aim - origin)};
  const auto t = intersect(sphere, ray, infinity);
  if (!t) return std::nullopt;
  return SphereHit{ray, point_on(sphere, ray.at(*t))};
}

}  // namespace

TEST_CASE("surface point: known points of the three shapes") {
  const SurfacePoint on_sphere = point_on(Sphere{{1, 2, 3}, 0.5f}, {1.0f, 2.51f, 3.0f});
  CHECK(on_sphere.position == vec3(1.0f, 2.5f, 3.0f));
  CHECK(on_sphere.normal == vec3(0, 1, 0));
  const SurfacePoint on_ground = point_on(Ground{0.5f}, {7.0f, 0.4999f, -2.0f});
  CHECK(on_ground.position == vec3(7.0f, 0.5f, -2.0f));
  CHECK(on_ground.normal == vec3(0, 1, 0));
  const Triangle triangle{{0, 0, 2}, {0, 4, 2}, {4, 0, 2}};
  const SurfacePoint on_triangle = point_on(triangle, {1.0f, 1.0f, 2.001f});
  CHECK(on_triangle.position == vec3(1, 1, 2));
  CHECK(on_triangle.normal == vec3(0, 0, -1));
}

TEST_CASE("surface point: is computed for the object that was hit") {
  Scene scene;
  scene.spheres = {{{0, 0, 5}, 1.0f}, {{10, 0, 5}, 2.0f}};
  scene.triangles = {Triangle{{19, -1, 5}, {19, 2, 5}, {22, -1, 5}}};
  scene.grounds = {{-3.0f}, {-7.0f}};
  const vec3 forward{0, 0, 1};
  const auto at = [&](vec3 origin, vec3 direction) {
    const Ray ray{origin, direction};
    return surface_point(scene, ray, *closest_hit(scene, ray));
  };
  CHECK(at({0, 0, 0}, forward).position == vec3(0, 0, 4));
  CHECK(at({10, 0, 0}, forward).position == vec3(10, 0, 3));
  CHECK(at({10, 0, 0}, forward).normal == vec3(0, 0, -1));
  CHECK(at({20, 0, 0}, forward).position == vec3(20, 0, 5));
  CHECK(at({20, 0, 0}, forward).normal == vec3(0, 0, -1));
  CHECK(at({30, 0, 0}, {0, -1, 0}).position == vec3(30, -3, 0));
  CHECK(at({30, -9, 0}, {0, 1, 0}).position == vec3(30, -7, 0));
}

TEST_CASE("surface point: lies nearer to the true surface than its position_error") {
  RandomCases random(16);
  for (int i = 0; i < 100'000; ++i) {
    const Sphere sphere = random_sphere(random);
    if (const auto hit = hit_sphere(random, sphere)) {
      REQUIRE(std::abs(height(sphere, hit->point.position)) < hit->point.position_error);
      REQUIRE(length(hit->point.normal) == Approx(1).epsilon(3e-7));
      const vec3 outward = normalize(hit->point.position - sphere.center);
      REQUIRE(dot(hit->point.normal, outward) > 0.99f);
    }
    const Triangle triangle =
        random.triangle(random.point_within(random.any_size(-1, 3)), random.any_size(-1, 1));
    const vec3 middle = (triangle.corner(0) + triangle.corner(1) + triangle.corner(2)) / 3.0f;
    const SurfacePoint point = point_on(triangle, middle + random.point_within(0.01f));
    REQUIRE(std::abs(height(triangle, point.position)) < point.position_error);
  }
}

TEST_CASE("surface point: re-projection is as good from far away") {
  // From 10 km the ray's own idea of the hit is off by a millimetre; the point on the sphere is
  // not.
  const Sphere sphere{{1.0f, 2.0f, 3.0f}, 1.0f};
  RandomCases random(17);
  double worst_before = 0;
  double worst_after = 0;
  for (int i = 0; i < 10'000; ++i) {
    const vec3 origin = 1e4f * random.direction();
    const Ray ray{origin, normalize(sphere.center - origin)};
    const auto t = intersect(sphere, ray, infinity);
    REQUIRE(t);
    worst_before = std::max(worst_before, std::abs(height(sphere, ray.at(*t))));
    worst_after =
        std::max(worst_after, std::abs(height(sphere, point_on(sphere, ray.at(*t)).position)));
  }
  CHECK(worst_before > 3e-4);
  CHECK(worst_after < 1e-6);
}

// Rounding puts about half of the points inside, some exactly on the sphere.
TEST_CASE("surface point: without an offset 30 to 50 % of rays hit the sphere that they leave") {
  RandomCases random(18);
  int all = 0;
  int self_hits = 0;
  while (all < 500'000) {
    const Sphere sphere{random.point_within(10.0f), random.uniform(0.1f, 2.0f)};
    const auto hit = hit_sphere(random, sphere);
    if (!hit) continue;
    ++all;
    const Ray next{hit->point.position, random.direction_above(hit->point.normal)};
    self_hits += intersect(sphere, next, infinity).has_value();
  }
  const double percent = 100.0 * self_hits / all;
  CAPTURE(percent);
  CHECK(percent > 30);
  CHECK(percent < 50);
}

TEST_CASE("surface point: leave() never hits the sphere that it leaves outward") {
  RandomCases random(19);
  for (int i = 0; i < 1'000'000; ++i) {
    const Sphere sphere = random_sphere(random);
    const auto hit = hit_sphere(random, sphere);
    if (!hit) continue;
    const Ray next = leave(hit->point, random.direction_above(hit->point.normal));
    if (intersect(sphere, next, infinity)) {
      CAPTURE(i, sphere.center, sphere.radius, next.origin, next.direction);
      REQUIRE_FALSE(intersect(sphere, next, infinity));
    }
  }
}

TEST_CASE("surface point: leave() inward crosses the sphere once and by the whole chord") {
  RandomCases random(20);
  for (int i = 0; i < 200'000; ++i) {
    const Sphere sphere{random.point_within(10.0f), random.uniform(0.1f, 2.0f)};
    const auto hit = hit_sphere(random, sphere);
    if (!hit) continue;
    const vec3 inward = -random.direction_above(hit->point.normal);
    const float cosine = -dot(inward, hit->point.normal);
    if (cosine < 0.01f) continue;
    // A chord at this angle to the radius; starting lower shortens it by the offset / cosine.
    const float chord = 2.0f * sphere.radius * cosine;
    const auto t = intersect(sphere, leave(hit->point, inward), infinity);
    REQUIRE(t);
    REQUIRE(*t == Approx(chord).margin(4.0f * hit->point.position_error / cosine));
  }
}

TEST_CASE("surface point: leave() never hits the triangle that it leaves to either side") {
  RandomCases random(21);
  for (int i = 0; i < 600'000; ++i) {
    const Triangle triangle =
        random.triangle(random.point_within(random.any_size(-1, 2)), random.any_size(-1, 1));
    const float w1 = random.uniform(0.01f, 0.5f);
    const float w2 = random.uniform(0.01f, 0.48f);
    const vec3 near_it =
        (1 - w1 - w2) * triangle.corner(0) + w1 * triangle.corner(1) + w2 * triangle.corner(2);
    const Ray next = leave(point_on(triangle, near_it), random.direction());
    if (intersect(triangle, next, infinity)) {
      CAPTURE(i, next.origin, next.direction);
      REQUIRE_FALSE(intersect(triangle, next, infinity));
    }
  }
}

TEST_CASE("surface point: leave() never hits the ground that it leaves to either side") {
  RandomCases random(22);
  for (int i = 0; i < 600'000; ++i) {
    const Ground ground{random.uniform(-1.0f, 1.0f) * random.any_size(-3.0f, 3.0f)};
    const vec3 near_it = random.point_within(random.any_size(-3.0f, 5.0f));
    const Ray next = leave(point_on(ground, near_it), random.direction());
    if (intersect(ground, next, infinity)) REQUIRE_FALSE(intersect(ground, next, infinity));
  }
}

TEST_CASE("surface point: leave() starts on the side to which it goes") {
  const SurfacePoint point{{0, 0, 0}, {0, 1, 0}, 1e-3f};
  CHECK(leave(point, {0, 1, 0}).origin == vec3(0, 1e-3f, 0));
  CHECK(leave(point, {0, -1, 0}).origin == vec3(0, -1e-3f, 0));
  CHECK(leave(point, normalize(vec3(5, 1, 0))).direction == normalize(vec3(5, 1, 0)));
}
