#include "api.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"

namespace exercise {

// The path is longer than any that was asked for.
struct TooDeep {};

struct Wall {
  Rgb emission{1.0};
  Rgb albedo{0.5};
  bool is_there = true;
  bool absorbs = false;
};

// A room from -1 to 1 in x, y and z. Walls 0 to 5: left, right, ground, ceiling, front, back.
class Scene {
 public:
  std::array<Wall, 6> walls;
  bool has_mirrors = false;  // otherwise matt

  // What was asked.
  mutable std::vector<Ray> rays;
  mutable std::vector<glm::dvec3> us;
  struct Inward {
    glm::dvec3 wo, normal;
  };
  mutable std::optional<Inward> inward;  // the first wo that pointed into a wall
};

namespace {

glm::dvec3 normal_of(int wall) {
  glm::dvec3 normal(0.0);
  normal[wall / 2] = wall % 2 == 0 ? 1.0 : -1.0;
  return normal;
}

// Follows the cosine: a point of the disk, lifted up from the wall.
glm::dvec3 matt_direction(int wall, glm::dvec3 u) {
  const double radius = std::sqrt(u.x);
  const double phi = 2 * std::acos(-1.0) * u.y;
  glm::dvec3 wi = std::sqrt(1 - u.x) * normal_of(wall);
  wi[(wall / 2 + 1) % 3] = radius * std::cos(phi);
  wi[(wall / 2 + 2) % 3] = radius * std::sin(phi);
  return wi;
}

}  // namespace

glm::dvec3 Random::next_vec3() {
  lt::TestRandom random(state_);
  state_ = random.next_bits();
  const double x = random.uniform();
  const double y = random.uniform();
  return {x, y, random.uniform()};
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
  if (hit < 0 || !scene.walls[static_cast<std::size_t>(hit)].is_there) return std::nullopt;
  return Surface{ray.origin + nearest * ray.direction,
                 scene.walls[static_cast<std::size_t>(hit)].emission, hit};
}

// Brighter from below, where no path of the tests goes.
Rgb background(const Scene& /*scene*/, glm::dvec3 direction) {
  return Rgb(direction.y > 0 ? 4.0 : 16.0);
}

std::optional<BsdfSample> sample_bsdf(const Scene& scene, const Surface& surface, glm::dvec3 wo,
                                      glm::dvec3 u) {
  const Wall& wall = scene.walls[static_cast<std::size_t>(surface.object)];
  const glm::dvec3 normal = normal_of(surface.object);
  scene.us.push_back(u);
  if (scene.us.size() > 500) throw TooDeep();
  if (dot(wo, normal) < 0 && !scene.inward) scene.inward = {wo, normal};
  if (wall.absorbs) return std::nullopt;
  if (scene.has_mirrors) return BsdfSample{2 * dot(wo, normal) * normal - wo, wall.albedo};
  return BsdfSample{matt_direction(surface.object, u), wall.albedo};
}

}  // namespace exercise

namespace {

using exercise::Random;
using exercise::Ray;
using exercise::Rgb;
using exercise::Scene;
using glm::dvec3;

enum Side { left, right, ground, ceiling, front, back };

// Obliquely upwards to the back, from a place off the middle.
const Ray oblique{{0.1, -0.2, 0.3}, glm::normalize(dvec3(0.4, 0.5, 0.7))};

std::string shown(Rgb c) {
  std::ostringstream text;
  text.precision(8);
  if (c.r == c.g && c.g == c.b)
    text << c.r;
  else
    text << '(' << c.r << ", " << c.g << ", " << c.b << ')';
  return text.str();
}

bool is_near(Rgb a, Rgb b) {
  return distance(a, b) < 1e-9;  // false for NaN
}

std::string gave(const std::string& what, Rgb value, Rgb expected) {
  return what + " gave " + shown(value) + " and should give " + shown(expected) + ".";
}

// One path, and only what it asked; nothing if it did not end.
std::optional<Rgb> traced(const Scene& scene, const Ray& ray, int depth) {
  scene.rays.clear();
  scene.us.clear();
  scene.inward.reset();
  Random random(1);
  try {
    return exercise::radiance(scene, ray, depth, random);
  } catch (const exercise::TooDeep&) {
    return std::nullopt;
  }
}

// Four paths, of depth 0 to 3.
using Four = std::array<double, 4>;

std::string shown(const Four& values) {
  std::ostringstream text;
  text << values[0] << ", " << values[1] << ", " << values[2] << ", " << values[3];
  return text.str();
}

bool are_near(const Four& a, const Four& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return std::abs(x - y) < 1e-9; });
}

// a + ab + abc ...: the emission of each wall of the way, dimmed by all before it. From the far
// end.
Rgb expected_along(const Scene& scene, const std::vector<Side>& way) {
  Rgb light(0.0);
  for (auto side = way.rbegin(); side != way.rend(); ++side)
    light = scene.walls[*side].emission + scene.walls[*side].albedo * light;
  return light;
}

}  // namespace

TEST_CASE("a closed room: each depth adds light that was scattered once more") {
  const Scene room;  // every wall: emission 1, albedo 1/2
  Four values{};
  for (int depth = 0; depth < 4; ++depth) {
    const auto value = traced(room, oblique, depth);
    lt::diagnose(value.has_value(), "depth-ignored",
                 "At depth " + std::to_string(depth) + " a path was scattered 500 times.");
    const Scene::Inward inward = room.inward.value_or(Scene::Inward{});
    lt::diagnose(
        !room.inward, "wo-points-in",
        "wo was " + shown(inward.wo) + " at a wall with the normal " + shown(inward.normal) + ".");
    values[static_cast<std::size_t>(depth)] = value->r;
  }
  for (std::size_t i = 1; i < room.us.size(); ++i)  // of depth 3
    lt::diagnose(room.us[i] != room.us[i - 1], "same-numbers",
                 "Bounces " + std::to_string(i) + " and " + std::to_string(i + 1) + " both got " +
                     shown(room.us[i]) + ".");
  const std::array<std::pair<const char*, Four>, 6> mistakes{{
      {"depth-off-by-one", {0, 1, 1.5, 1.75}},
      {"depth-off-by-one", {1.5, 1.75, 1.875, 1.9375}},
      {"throughput-before-emission", {0.5, 0.75, 0.875, 0.9375}},
      {"throughput-forgotten", {1, 2, 3, 4}},
      {"last-weight-only", {1, 1.5, 2, 2.5}},
      {"emission-overwritten", {1, 0.5, 0.25, 0.125}},
  }};
  const Four expected{1, 1.5, 1.75, 1.875};
  const std::string seen = "With emission 1 and albedo 0.5, depths 0 to 3 gave " + shown(values) +
                           " and should give " + shown(expected) + ".";
  for (const auto& [tag, wrong] : mistakes)
    lt::diagnose(!are_near(values, wrong), tag, seen);
  INFO(seen);
  REQUIRE(are_near(values, expected));
  lt::measured("with emission 1 and albedo 0.5, depths 0 to 3 give " + shown(values) +
               ", on the way to 2");
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
  for (std::size_t depth = 0; depth < way.size(); ++depth) {
    const auto value = traced(room, ray, static_cast<int>(depth));
    REQUIRE(value.has_value());
    if (room.rays.size() > 1)
      lt::diagnose(room.rays[1].origin != room.rays[0].origin, "origin-not-moved",
                   "The first ray of a path met a wall at (0.5, 1, 0), and the second started at "
                   "(0, 0, 0), as the first did.");
    const std::vector<Side> so_far(way.begin(), way.begin() + static_cast<int>(depth) + 1);
    const Rgb expected = expected_along(room, so_far);
    INFO(gave("A path of depth " + std::to_string(depth), *value, expected));
    REQUIRE(is_near(*value, expected));
  }
}

TEST_CASE("a room without a ceiling: the sky counts, dimmed as all else") {
  Scene room;  // emission 1, albedo 1/2; a sky of 4 above
  room.has_mirrors = true;
  room.walls[ceiling].is_there = false;
  const Ray up{{0, 0, 0}, {0, 1, 0}};
  const Ray down{{0, 0, 0}, {0, -1, 0}};
  const Rgb value = traced(room, down, 1).value_or(Rgb(NAN));
  const Rgb deeper = traced(room, down, 4).value_or(Rgb(NAN));
  const std::string what = "A floor of emission 1 and albedo 0.5 under a sky of 4";
  // A path of depth 4 ends at the sky too: the same mistake has to show in both.
  const auto both_are = [&](double c) { return is_near(value, Rgb(c)) && is_near(deeper, Rgb(c)); };
  const std::string seen = gave(what, value, Rgb(3));
  lt::diagnose(!both_are(1), "sky-forgotten", seen);
  lt::diagnose(!both_are(5), "sky-undimmed", seen);
  lt::diagnose(!both_are(2) && !both_are(4), "gathered-light-lost", seen);
  INFO(what << " gave " << shown(value) << " at depth 1 and " << shown(deeper)
            << " at depth 4, and should give 3 at both.");
  REQUIRE((is_near(value, Rgb(3)) && is_near(deeper, Rgb(3))));
  for (const auto& [ray, depth, expected] :
       {std::tuple(down, 0, 1.0), std::tuple(up, 0, 4.0), std::tuple(up, 3, 4.0)}) {
    const Rgb light = traced(room, ray, depth).value_or(Rgb(NAN));
    INFO(gave("A ray along " + shown(ray.direction) + ", at depth " + std::to_string(depth) + ',',
              light, Rgb(expected)));
    REQUIRE(is_near(light, Rgb(expected)));
  }
}

TEST_CASE("a wall that absorbs all light ends the path, and its own light counts") {
  Scene room;
  room.has_mirrors = true;
  room.walls[ceiling].emission = Rgb(4);
  room.walls[ceiling].absorbs = true;
  const Ray down{{0, 0, 0}, {0, -1, 0}};
  const Rgb value = traced(room, down, 5).value_or(Rgb(NAN));
  const std::string seen =
      gave("From a floor (emission 1, albedo 0.5) to a ceiling that absorbs (emission 4)", value,
           Rgb(3));
  lt::diagnose(!is_near(value, Rgb(0)) && !is_near(value, Rgb(1)), "absorbed-is-black", seen);
  INFO(seen);
  REQUIRE(is_near(value, Rgb(3)));
}

TEST_CASE("any closed room of one colour gives Le (1 - a^(depth + 1)) / (1 - a)") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int depth = 0; depth <= 20; ++depth) {
      const Rgb emission(random.uniform(), random.uniform(), random.uniform());
      const Rgb albedo(random.uniform(0, 0.9), random.uniform(0, 0.9), random.uniform(0, 0.9));
      Scene room;
      room.walls.fill({emission, albedo});
      const Rgb expected = emission * (1.0 - glm::pow(albedo, Rgb(depth + 1))) / (1.0 - albedo);
      const Rgb value = traced(room, {{0, 0, 0}, random.direction()}, depth).value_or(Rgb(NAN));
      INFO(gave("Depth " + std::to_string(depth), value, expected));
      REQUIRE(is_near(value, expected));
    }
  }
}
