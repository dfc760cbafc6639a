#include "api.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"

namespace exercise {

struct Wall {
  Rgb emission{1.0}, albedo{0.5};
  bool is_there = true, absorbs = false;
};

// A room from -1 to 1 in x, y and z. Walls 0 to 5: left, right, ground, ceiling, front, back.
class Scene {
 public:
  std::array<Wall, 6> walls;
  bool has_mirrors = false;       // otherwise matt
  mutable std::vector<Ray> rays;  // all that was asked
  mutable std::vector<glm::dvec3> us;
  mutable std::optional<glm::dvec3> outward_wo;  // the first wo that pointed out of the room
};

namespace {

glm::dvec3 three(lt::TestRandom& random, double high) {
  glm::dvec3 numbers;
  for (int i = 0; i < 3; ++i)
    numbers[i] = random.uniform(0, high);
  return numbers;
}

glm::dvec3 normal_of(int wall) {
  glm::dvec3 normal(0.0);
  normal[wall / 2] = wall % 2 == 0 ? 1.0 : -1.0;
  return normal;
}

// Follows the cosine: a point of the disk, lifted up from the wall.
glm::dvec3 matt_direction(glm::dvec3 n, glm::dvec3 u) {
  const double phi = 2 * std::acos(-1.0) * u.y;
  const glm::dvec3 on_disk =
      std::cos(phi) * glm::dvec3(n.y, n.z, n.x) + std::sin(phi) * glm::dvec3(n.z, n.x, n.y);
  return std::sqrt(u.x) * on_disk + std::sqrt(1 - u.x) * n;
}

}  // namespace

glm::dvec3 Random::next_vec3() {
  lt::TestRandom random(state_);
  state_ = random.next_bits();
  return three(random, 1);
}

std::optional<Surface> closest_hit(const Scene& scene, const Ray& ray) {
  scene.rays.push_back(ray);
  double nearest = INFINITY;
  int hit = -1;
  for (int wall = 0; wall < 6; ++wall) {
    const double approach = -dot(normal_of(wall), ray.direction);
    const double t = (1 + dot(normal_of(wall), ray.origin)) / approach;
    if (approach <= 0 || t <= 0 || t >= nearest) continue;
    nearest = t;
    hit = wall;
  }
  if (hit < 0 || !scene.walls[hit].is_there) return std::nullopt;
  return Surface{ray.origin + nearest * ray.direction, scene.walls[hit].emission, hit};
}

// Brighter from below, where no path of the tests goes.
Rgb background(const Scene& /*scene*/, glm::dvec3 direction) {
  return Rgb(direction.y > 0 ? 4.0 : 16.0);
}

std::optional<BsdfSample> sample_bsdf(const Scene& scene, const Surface& surface, glm::dvec3 wo,
                                      glm::dvec3 u) {
  const Wall& wall = scene.walls[surface.object];
  const glm::dvec3 normal = normal_of(surface.object);
  scene.us.push_back(u);
  if (dot(wo, normal) < 0 && !scene.outward_wo) scene.outward_wo = wo;
  if (wall.absorbs || scene.us.size() >= 500) return std::nullopt;
  if (scene.has_mirrors) return BsdfSample{2 * dot(wo, normal) * normal - wo, wall.albedo};
  return BsdfSample{matt_direction(normal, u), wall.albedo};
}

}  // namespace exercise

namespace {

using exercise::Ray;
using exercise::Rgb;
using exercise::Scene;
using glm::dvec3;

enum Side { left, right, ground, ceiling, front, back };

std::string shown(Rgb c) {
  std::ostringstream text;
  text.precision(8);
  text << '(' << c.r << ", " << c.g << ", " << c.b << ')';
  return c == Rgb(c.r) ? text.str().substr(1, text.str().find(',') - 1) : text.str();
}

bool is_near(Rgb a, Rgb b) {
  return distance(a, b) < 1e-9;  // false for NaN
}

std::string gave(const std::string& what, Rgb value, Rgb expected) {
  return what + " gave " + shown(value) + " and should give " + shown(expected) + ".";
}

bool is_right(const std::string& what, Rgb value, Rgb expected) {
  if (!is_near(value, expected)) UNSCOPED_INFO(gave(what, value, expected));
  return is_near(value, expected);
}

// One path, and only what it asked.
Rgb traced(const Scene& scene, const Ray& ray, int depth, std::uint64_t seed = 1) {
  scene.rays.clear();
  scene.us.clear();
  scene.outward_wo.reset();
  exercise::Random random(seed);
  return radiance(scene, ray, depth, random);
}

// The emission of each wall of the way, dimmed by all before it; summed from the far end.
Rgb expected_along(const Scene& scene, const std::vector<Side>& way) {
  Rgb light(0.0);
  for (auto side = way.rbegin(); side != way.rend(); ++side)
    light = scene.walls[*side].emission + scene.walls[*side].albedo * light;
  return light;
}

}  // namespace

TEST_CASE("a closed room: each depth adds light that was scattered once more") {
  const Scene room;  // every wall: emission 1, albedo 1/2
  const Ray oblique{{0.1, -0.2, 0.3}, glm::normalize(dvec3(0.4, 0.5, 0.7))};
  glm::dvec4 values(0);
  for (int depth = 0; depth < 4; ++depth) {
    values[depth] = traced(room, oblique, depth).r;
    lt::diagnose(room.us.size() < 500, "depth-ignored",
                 "At depth " + std::to_string(depth) + " a path was scattered 500 times.");
    lt::diagnose(!room.outward_wo, "wo-points-in",
                 "wo was " + shown(room.outward_wo.value_or(dvec3(0))) + ", out of the room.");
  }
  for (std::size_t i = 1; i < room.us.size(); ++i)  // of depth 3
    lt::diagnose(room.us[i] != room.us[i - 1], "same-numbers",
                 "Bounces " + std::to_string(i) + " and " + std::to_string(i + 1) + " both got " +
                     shown(room.us[i]) + ".");
  const std::array<std::pair<const char*, glm::dvec4>, 6> mistakes{{
      {"depth-off-by-one", {0, 1, 1.5, 1.75}},
      {"depth-off-by-one", {1.5, 1.75, 1.875, 1.9375}},
      {"throughput-before-emission", {0.5, 0.75, 0.875, 0.9375}},
      {"throughput-forgotten", {1, 2, 3, 4}},
      {"last-weight-only", {1, 1.5, 2, 2.5}},
      {"emission-overwritten", {1, 0.5, 0.25, 0.125}},
  }};
  const glm::dvec4 expected{1, 1.5, 1.75, 1.875};
  const std::string seen = "With emission 1 and albedo 0.5, depths 0 to 3 gave " +
                           Catch::Detail::stringify(values) + " and should give " +
                           Catch::Detail::stringify(expected) + ".";
  for (const auto& [tag, wrong] : mistakes)
    lt::diagnose(!(distance(values, wrong) < 1e-9), tag, seen);
  if (!(distance(values, expected) < 1e-9)) FAIL(seen);
  const std::vector<dvec3> first = room.us;
  (void)traced(room, oblique, 3, 2);
  if (room.us == first)
    FAIL("Two generators gave the same path: its numbers must come from the one handed in.");
  lt::measured(
      "with emission 1 and albedo 0.5, depths 0 to 3 give 1, 1.5, 1.75 and 1.875, on the way to 2");
}

TEST_CASE("a room of two colours: the walls count in the order of the path") {
  // The path, in the plane z = 0: up from the middle to (0.5, 1), to the right wall at (1, 0), down
  // to (0.5, -1), up again through the middle to (-0.5, 1), and so on.
  Scene room;
  room.has_mirrors = true;
  for (const Side side : {left, right, front, back})
    room.walls[side] = {{0, 1, 0.25}, {0.25, 0.5, 1}};
  for (const Side side : {ground, ceiling})
    room.walls[side] = {{1, 0, 0.5}, {0.5, 0.25, 0.75}};
  const Ray ray{{0, 0, 0}, glm::normalize(dvec3(1, 2, 0))};
  const std::vector<Side> way{ceiling, right, ground, ceiling, left, ground};
  for (int depth = 0; depth < 6; ++depth) {
    const Rgb value = traced(room, ray, depth);
    lt::diagnose(room.rays.size() < 2 || room.rays[1].origin != room.rays[0].origin,
                 "origin-not-moved",
                 "The first ray of a path met a wall at (0.5, 1, 0), and the second started at "
                 "(0, 0, 0), as the first did.");
    const Rgb expected = expected_along(room, {way.begin(), way.begin() + depth + 1});
    REQUIRE(is_right("A path of depth " + std::to_string(depth), value, expected));
  }
}

TEST_CASE("a room without a ceiling: the sky counts, dimmed as all else") {
  Scene room;  // emission 1, albedo 1/2; a sky of 4 above
  room.has_mirrors = true;
  room.walls[ceiling].is_there = false;
  const Ray down{{0, 0, 0}, {0, -1, 0}};
  const Rgb value = traced(room, down, 1);
  const Rgb deeper = traced(room, down, 4);
  const std::string what = "A floor of emission 1 and albedo 0.5 under a sky of 4";
  // A path of depth 4 ends at the sky too: the same mistake has to show in both.
  const auto both_are = [&](double c) { return is_near(value, Rgb(c)) && is_near(deeper, Rgb(c)); };
  const std::string seen = gave(what, value, Rgb(3));
  lt::diagnose(!both_are(1), "sky-forgotten", seen);
  lt::diagnose(!both_are(5), "sky-undimmed", seen);
  lt::diagnose(!both_are(2) && !both_are(4), "gathered-light-lost", seen);
  REQUIRE(is_right(what, value, Rgb(3)));
  REQUIRE(is_right(what + ", at depth 4,", deeper, Rgb(3)));
  REQUIRE(is_right("The floor at depth 0", traced(room, down, 0), Rgb(1)));
  REQUIRE(is_right("A look at the sky", traced(room, {{0, 0, 0}, {0, 1, 0}}, 0), Rgb(4)));
}

TEST_CASE("a wall that absorbs all light ends the path, and its own light counts") {
  Scene room;
  room.has_mirrors = true;
  room.walls[ceiling].emission = Rgb(4);
  const Ray down{{0, 0, 0}, {0, -1, 0}};
  REQUIRE(is_right("From a floor to a bright ceiling, depth 1", traced(room, down, 1), Rgb(3)));
  room.walls[ceiling].absorbs = true;
  const Rgb value = traced(room, down, 5);
  const std::string what =
      "From a floor (emission 1, albedo 0.5) to a ceiling that absorbs (emission 4)";
  lt::diagnose(!is_near(value, Rgb(0)) && !is_near(value, Rgb(1)), "absorbed-is-black",
               gave(what, value, Rgb(3)));
  REQUIRE(is_right(what, value, Rgb(3)));
}

TEST_CASE("any closed room of one colour gives Le (1 - a^(depth + 1)) / (1 - a)") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int depth = 0; depth <= 20; ++depth) {
      const Rgb emission = exercise::three(random, 1);
      const Rgb albedo = exercise::three(random, 0.9);
      Scene room;
      room.walls.fill({emission, albedo});
      const Rgb expected = emission * (1.0 - glm::pow(albedo, Rgb(depth + 1))) / (1.0 - albedo);
      const Rgb value = traced(room, {{0, 0, 0}, random.direction()}, depth);
      REQUIRE(is_right("Depth " + std::to_string(depth), value, expected));
    }
  }
}
