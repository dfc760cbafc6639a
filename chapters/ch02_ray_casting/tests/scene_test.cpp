#include "ch02_ray_casting/scene.hpp"

#include "ch02_ray_casting/mistakes.hpp"
#include "ch02_ray_casting/tests/reference.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// Where each object would be hit, in double; `is_clear` is false if the ray passes so near to a rim
// or an edge that rounding may decide.
struct Candidate {
  double t = reference::nowhere;
  bool is_clear = true;
};

Candidate candidate(const Sphere& sphere, const Ray& ray) {
  const auto roots = reference::sphere_roots(sphere, ray);
  Candidate found;
  found.is_clear = std::abs(roots.miss_distance - sphere.radius) > 1e-4;
  if (roots.far > 0) found.t = roots.near > 0 ? roots.near : roots.far;
  return found;
}

Candidate candidate(const Triangle& triangle, const Ray& ray) {
  const auto [t, weights] = reference::triangle_hit(triangle, ray);
  const double inside_by = std::min({weights.x, weights.y, weights.z});
  Candidate found;
  found.is_clear = std::abs(inside_by) > 1e-3;
  if (t > 0 && inside_by > 0) found.t = t;
  return found;
}

Candidate candidate(const Ground& ground, const Ray& ray) {
  const double t = reference::ground_t(ground, ray);
  return {t > 0 ? t : reference::nowhere, true};
}

Scene random_scene(RandomCases& random) {
  Scene scene;
  for (int i = 0; i < 12; ++i)
    scene.spheres.push_back({random.point_within(5.0f), random.uniform(0.1f, 1.5f)});
  for (int i = 0; i < 12; ++i)
    scene.triangles.push_back(random.triangle(random.point_within(5.0f), 2.0f));
  scene.grounds = {{-4.0f}, {4.5f}};
  return scene;
}

}  // namespace

TEST_CASE("scene: objects are numbered spheres then triangles then grounds") {
  Scene scene;
  scene.spheres = {{{0, 0, 5}, 1.0f}, {{10, 0, 5}, 1.0f}};
  scene.triangles = {Triangle{{19, -1, 5}, {22, -1, 5}, {19, 2, 5}}};
  scene.grounds = {{-50.0f}, {50.0f}};
  CHECK(scene.object_count() == 5);
  const vec3 forward{0, 0, 1};
  CHECK(closest_hit(scene, Ray{{0, 0, 0}, forward})->object == 0);
  CHECK(closest_hit(scene, Ray{{10, 0, 0}, forward})->object == 1);
  CHECK(closest_hit(scene, Ray{{20, 0, 0}, forward})->object == 2);
  CHECK(closest_hit(scene, Ray{{30, 0, 0}, {0, -1, 0}})->object == 3);
  CHECK(closest_hit(scene, Ray{{30, 0, 0}, {0, 1, 0}})->object == 4);
}

TEST_CASE("scene: nothing is hit where there is nothing") {
  CHECK_FALSE(closest_hit(Scene{}, Ray{{0, 0, 0}, {0, 0, 1}}));
}

TEST_CASE("scene: the nearest counts in whatever order the objects are") {
  const vec3 forward{0, 0, 1};
  for (const bool is_reversed : {false, true}) {
    Scene scene;
    scene.spheres = {{{0, 0, 5}, 1.0f}, {{0, 0, 9}, 1.0f}, {{0, 0, 13}, 1.0f}};
    if (is_reversed) std::swap(scene.spheres[0], scene.spheres[2]);
    const auto hit = closest_hit(scene, Ray{{0, 0, 0}, forward});
    REQUIRE(hit);
    CHECK(hit->t == 4.0f);
    CHECK(hit->object == (is_reversed ? 2 : 0));
  }
}

TEST_CASE("scene: of two at one distance the first counts") {
  Scene scene;
  scene.spheres = {{{0, 0, 5}, 1.0f}, {{0, 0, 5}, 1.0f}};
  CHECK(closest_hit(scene, Ray{{0, 0, 0}, {0, 0, 1}})->object == 0);
}

TEST_CASE("scene: hits at t_max or beyond do not count") {
  Scene scene;
  scene.spheres = {{{0, 0, 5}, 1.0f}};
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  CHECK(closest_hit(scene, ray, std::nextafter(4.0f, 5.0f)));
  CHECK_FALSE(closest_hit(scene, ray, 4.0f));
  CHECK_FALSE(closest_hit(scene, ray, 1.0f));
}

TEST_CASE("scene: the closest hit is the one that asking everybody in double gives") {
  RandomCases random(9);
  int compared = 0;
  for (int s = 0; s < 200; ++s) {
    const Scene scene = random_scene(random);
    for (int i = 0; i < 100; ++i) {
      const Ray ray{random.point_within(4.0f), random.direction()};
      std::vector<Candidate> all;
      for (const auto& sphere : scene.spheres)
        all.push_back(candidate(sphere, ray));
      for (const auto& triangle : scene.triangles)
        all.push_back(candidate(triangle, ray));
      for (const auto& ground : scene.grounds)
        all.push_back(candidate(ground, ray));

      const auto by_t = [](const Candidate& a, const Candidate& b) { return a.t < b.t; };
      const auto nearest = std::ranges::min_element(all, by_t);
      const bool is_clear = std::ranges::all_of(all, &Candidate::is_clear) && nearest->t > 1e-3;
      const auto is_tie = [&](const Candidate& c) {
        return &c != &*nearest && c.t < nearest->t + 1e-3;
      };
      if (!is_clear || std::ranges::any_of(all, is_tie)) continue;

      ++compared;
      const auto hit = closest_hit(scene, ray);
      REQUIRE(hit.has_value() == (nearest->t < reference::nowhere));
      if (!hit) continue;
      REQUIRE(hit->object == static_cast<std::uint32_t>(nearest - all.begin()));
      REQUIRE(hit->t == Approx(nearest->t).epsilon(1e-4));
    }
  }
  CHECK(compared > 18'000);
}

TEST_CASE("scene: comparing every object with every other finds the same but for NaN") {
  RandomCases random(10);
  for (int s = 0; s < 20; ++s) {
    Scene scene = random_scene(random);
    scene.triangles.clear();  // careless about edges
    for (int i = 0; i < 100; ++i) {
      const Ray ray{random.point_within(4.0f), random.direction()};
      const auto once = closest_hit(scene, ray);
      const auto pairs = mistakes::closest_hit(scene, ray);
      REQUIRE(once.has_value() == pairs.has_value());
      if (once) REQUIRE((once->t == pairs->t && once->object == pairs->object));
    }
  }
}
