#include "ch02_ray_casting/sphere.hpp"

#include "ch02_ray_casting/mistakes.hpp"
#include "ch02_ray_casting/tests/reference.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// Along +x, past the origin at height y.
Ray along_x(float from, float y) {
  return {{from, y, 0.0f}, {1.0f, 0.0f, 0.0f}};
}

const Sphere unit_sphere{vec3(0.0f), 1.0f};

}  // namespace

TEST_CASE("sphere: from outside the nearer of two crossings counts") {
  // 3-4-5 triangle: at height 0.6 the sphere reaches from x = -0.8 to x = 0.8.
  const auto t = intersect(unit_sphere, along_x(-3.0f, 0.6f), infinity);
  REQUIRE(t);
  CHECK(*t == Approx(2.2f).epsilon(1e-6));
}

TEST_CASE("sphere: from inside the way out counts") {
  CHECK(*intersect(unit_sphere, along_x(0.0f, 0.0f), infinity) == 1.0f);
  CHECK(*intersect(unit_sphere, along_x(0.5f, 0.0f), infinity) == 0.5f);
  CHECK(*intersect(unit_sphere, along_x(-0.5f, 0.0f), infinity) == 1.5f);
  CHECK(*intersect(unit_sphere, along_x(0.0f, 0.6f), infinity) == Approx(0.8f).epsilon(1e-6));
}

TEST_CASE("sphere: behind the ray is a miss") {
  CHECK_FALSE(intersect(unit_sphere, along_x(3.0f, 0.0f), infinity));
  CHECK_FALSE(intersect(unit_sphere, along_x(1.001f, 0.0f), infinity));
}

TEST_CASE("sphere: a ray that passes beside it is a miss") {
  CHECK_FALSE(intersect(unit_sphere, along_x(-3.0f, 1.001f), infinity));
  CHECK_FALSE(intersect(unit_sphere, along_x(0.0f, 1.001f), infinity));
}

TEST_CASE("sphere: a tangent ray touches once") {
  // Discriminant 1 - 1 = 0: both crossings are at the point of contact.
  CHECK(*intersect(unit_sphere, along_x(-3.0f, 1.0f), infinity) == 3.0f);
  CHECK_FALSE(intersect(unit_sphere, along_x(-3.0f, std::nextafter(1.0f, 2.0f)), infinity));
}

TEST_CASE("sphere: t_max itself does not count") {
  const Ray ray = along_x(-3.0f, 0.0f);  // crossings at 2 and 4
  CHECK(intersect(unit_sphere, ray, std::nextafter(2.0f, 3.0f)));
  CHECK_FALSE(intersect(unit_sphere, ray, 2.0f));
  CHECK_FALSE(intersect(unit_sphere, along_x(0.0f, 0.0f), 1.0f));
}

TEST_CASE("sphere: from a point on the surface the other side counts") {
  CHECK(*intersect(unit_sphere, along_x(-1.0f, 0.0f), infinity) == 2.0f);
  CHECK_FALSE(intersect(unit_sphere, along_x(1.0f, 0.0f), infinity));
  CHECK_FALSE(intersect(unit_sphere, Ray{{1, 0, 0}, {0, 1, 0}}, infinity));  // along the surface
}

TEST_CASE("sphere: the 26 directions from the centre leave at one radius and come back") {
  const Sphere sphere{{1.0f, 2.0f, 3.0f}, 0.25f};
  for (const vec3 d : cube_directions()) {
    CHECK(*intersect(sphere, Ray{sphere.center, d}, infinity) == Approx(0.25f).epsilon(1e-6));
    const Ray inward{sphere.center - 2.0f * d, d};
    CHECK(*intersect(sphere, inward, infinity) == Approx(1.75f).epsilon(1e-6));
    CHECK_FALSE(intersect(sphere, Ray{inward.origin, -d}, infinity));
  }
}

TEST_CASE("sphere: at a distance of 10 km the stable discriminant has its digits") {
  // Radius 1 m, passed at 0.9 m: 1 - 0.81 = 0.19. The school formula subtracts two numbers near
  // 1e8, which floats tell apart in steps of 8.
  const Sphere sphere{{0.0f, 0.0f, 1e4f}, 1.0f};
  const Ray ray{{0.9f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
  CHECK(mistakes::discriminant(sphere, ray) == 0.0f);
  // t = 1e4 - sqrt(0.19); floats near 1e4 are 1/1024 apart.
  const auto t = intersect(sphere, ray, infinity);
  REQUIRE(t);
  CHECK(*t == Approx(1e4 - std::sqrt(0.19)).margin(1.0 / 1024));
}

TEST_CASE(
    "sphere: at a distance of 1,000 km a sphere of 1 m is hit and missed where it should be") {
  const Sphere sphere{{0.0f, 1e6f, 0.0f}, 1.0f};
  const vec3 up{0.0f, 1.0f, 0.0f};
  // Floats near 1e6 are 1/16 apart.
  const auto t = intersect(sphere, Ray{{0.5f, 0.0f, 0.0f}, up}, infinity);
  REQUIRE(t);
  CHECK(*t == Approx(1e6 - std::sqrt(0.75)).margin(1.0 / 16));
  CHECK_FALSE(intersect(sphere, Ray{{1.01f, 0.0f, 0.0f}, up}, infinity));
}

TEST_CASE("sphere: sizes from a grain of dust to a planet") {
  for (const float radius : {1e-5f, 1e-3f, 1.0f, 1e3f, 6.4e6f}) {
    const Sphere sphere{vec3(0.0f), radius};
    const Ray ray{{-3.0f * radius, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
    CHECK(*intersect(sphere, ray, infinity) == Approx(2.0f * radius).epsilon(1e-6));
  }
}

// With f = from_center and u = 2^-24: `closest` carries an error of at most 6 u |f| (b: 4 u |f|,
// the product and the difference: 1 u |f| each), so the ray seems shifted by that much, and so do b
// and the root. The quotient c / q adds 3 u |f|. In all the crossing lies within 16 u (|f| + R) of
// the surface; along the ray that is longer by 1 / cosine. A ray that passes the rim closer than
// that may fall on either side.
TEST_CASE("sphere: agrees with the school formula in long double within the derived error") {
  RandomCases random(2);
  int hits = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Sphere sphere{random.point_within(10.0f), random.any_size(-2.0f, 2.0f)};
    const float from = sphere.radius * random.any_size(-1.0f, 3.0f);
    const Ray line{sphere.center + from * random.direction(), vec3(0.0f)};
    const vec3 aim = sphere.center + random.point_within(1.5f * sphere.radius);
    const Ray ray{line.origin, normalize(aim - line.origin)};

    const double distance = length(glm::dvec3(ray.origin) - glm::dvec3(sphere.center));
    const double error = 16 * reference::u * (distance + sphere.radius);
    const auto roots = reference::sphere_roots(sphere, ray);
    const bool is_at_rim = std::abs(roots.miss_distance - sphere.radius) < error;
    const bool is_on_surface = std::abs(distance - sphere.radius) < error;
    if (is_at_rim || is_on_surface) continue;

    const double expected = roots.near > 0 ? roots.near : roots.far;
    const auto t = intersect(sphere, ray, infinity);
    const bool is_hit = expected > 0 && expected < reference::nowhere;
    if (t.has_value() != is_hit) {
      CAPTURE(i, sphere.center, sphere.radius, ray.origin, ray.direction);
      REQUIRE(t.has_value() == is_hit);
    }
    if (!t) continue;
    ++hits;
    const double sine = roots.miss_distance / sphere.radius;
    const double allowed = error / std::sqrt(1 - sine * sine);
    if (std::abs(*t - expected) > allowed) {
      CAPTURE(i, *t, expected, allowed);
      REQUIRE(std::abs(*t - expected) <= allowed);
    }
  }
  CHECK(hits > 50'000);  // it did compare
}
