#include "api.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::intersect;
using exercise::Ray;
using exercise::Triangle;
using exercise::TriangleHit;
using glm::dvec2;
using glm::dvec3;
using MaybeHit = std::optional<TriangleHit>;

// In the plane z = 0: right angle at the origin, legs of 2 and 1. The weights at (x, y) are
// 1 - x / 2 - y, x / 2 and y.
const Triangle right_angled{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};

Ray along_z(double x, double y) {
  return {{x, y, -3}, {0, 0, 1}};
}

std::string shown(dvec3 v) {
  std::ostringstream text;
  text.precision(10);  // enough to see what float arithmetic loses
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

std::string shown(const MaybeHit& hit) {
  if (!hit) return "nothing";
  if (std::isnan(hit->t)) return "t = nan";
  std::ostringstream text;
  text.precision(10);
  text << "t = " << hit->t << " with weights " << shown(hit->weights);
  return text.str();
}

std::string gave(const Triangle& triangle, const Ray& ray, const std::string& expected) {
  return "gave " + shown(intersect(triangle, ray)) + " and should give " + expected +
         ": the ray from " + shown(ray.origin) + " along " + shown(ray.direction) +
         " at the corners " + shown(triangle.p0) + ", " + shown(triangle.p1) + ", " +
         shown(triangle.p2) + ".";
}

bool is_near(dvec3 a, dvec3 b) {
  return distance(a, b) < 1e-9;  // false for NaN
}

dvec3 point_of(const Triangle& triangle, dvec3 weights) {
  return weights.x * triangle.p0 + weights.y * triangle.p1 + weights.z * triangle.p2;
}

// Is the answer the expected one, and do its t and its weights name the same point?
bool is_right(const Triangle& triangle, const Ray& ray, const MaybeHit& expected) {
  const MaybeHit hit = intersect(triangle, ray);
  const bool is_same =
      hit.has_value() == expected.has_value() &&
      (!hit || (std::abs(hit->t - expected->t) * length(ray.direction) < 1e-9 &&
                std::abs(hit->weights.x + hit->weights.y + hit->weights.z - 1) < 1e-9 &&
                is_near(point_of(triangle, hit->weights), ray.origin + hit->t * ray.direction)));
  if (!is_same) UNSCOPED_INFO(gave(triangle, ray, shown(expected)));
  return is_same;
}

// No thin ones: twice the area is at least a fifth of the longest edge squared.
Triangle random_triangle(lt::TestRandom& random) {
  const double size = random.uniform(0.1, 3);
  while (true) {
    std::array<dvec3, 3> p{};
    for (dvec3& corner : p)
      corner = size * random.direction();
    const double longest =
        std::max({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[0])});
    if (length(cross(p[1] - p[0], p[2] - p[0])) > 0.2 * longest * longest)
      return {p[0], p[1], p[2]};
  }
}

double cosine_between(const Triangle& triangle, dvec3 unit_direction) {
  const dvec3 across = cross(triangle.p1 - triangle.p0, triangle.p2 - triangle.p0);
  return std::abs(dot(normalize(across), unit_direction));
}

// A view along a direction, in which a triangle is flat.
class View {
 public:
  explicit View(dvec3 ahead) : ahead_(ahead) {
    const dvec3 any = std::abs(ahead.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    right_ = normalize(cross(any, ahead));
    up_ = cross(ahead, right_);
  }
  [[nodiscard]] dvec2 seen(dvec3 p) const { return {dot(p, right_), dot(p, up_)}; }
  // Ahead for a `way` of 1, back from the other side for -1.
  [[nodiscard]] Ray ray_at(dvec2 place, double way) const {
    return {place.x * right_ + place.y * up_ - 10.0 * way * ahead_, way * ahead_};
  }

 private:
  dvec3 ahead_, right_, up_;
};

// Positive to the left of the way from a to b, negative to its right; metres.
double left_of(dvec2 a, dvec2 b, dvec2 p) {
  const dvec2 way = normalize(b - a);
  return way.x * (p.y - a.y) - way.y * (p.x - a.x);
}

// n x n rays both ways against a test in the flat picture. Returns the share of the square from
// -reach to reach that the triangle covers, or -1 if a ray disagrees.
double covered_share(const Triangle& triangle, const View& view, double reach, int n) {
  const std::array<dvec2, 3> corners{view.seen(triangle.p0), view.seen(triangle.p1),
                                     view.seen(triangle.p2)};
  int covered = 0;
  for (int i = 0; i < n * n; ++i) {
    const dvec2 place = reach * ((2.0 * dvec2(i % n, i / n) + 1.0) / double(n) - 1.0);
    int left = 0;
    double nearest = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double side = left_of(corners[k], corners[(k + 1) % 3], place);
      left += side > 0;
      nearest = std::min(nearest, std::abs(side));
    }
    if (nearest < 1e-6) continue;  // on an edge either answer is right
    const bool is_inside = left == 0 || left == 3;
    covered += is_inside;
    for (const double way : {1.0, -1.0}) {
      const Ray ray = view.ray_at(place, way);
      if (intersect(triangle, ray).has_value() == is_inside) continue;
      UNSCOPED_INFO(gave(triangle, ray, is_inside ? "a hit" : "nothing"));
      return -1;
    }
  }
  return covered / double(n * n);
}

}  // namespace

TEST_CASE("a triangle ends at its three edges") {
  const Ray inside = along_z(0.6, 0.2);
  const Ray beyond = along_z(1.4, 0.8);  // weights -0.5, 0.7, 0.8
  const Ray left = along_z(-0.4, 0.5);   // weight of corner 1 is -0.2
  const Ray below = along_z(0.6, -0.5);  // weight of corner 2 is -0.5
  const MaybeHit hit = intersect(right_angled, inside);
  const bool two_edges_hold =
      hit && !intersect(right_angled, left) && !intersect(right_angled, below);
  lt::diagnose(!(two_edges_hold && intersect(right_angled, beyond)), "u-plus-v-unchecked",
               gave(right_angled, beyond, "nothing"));

  const TriangleHit expected{3, {0.5, 0.3, 0.2}};
  bool is_mixed_up = false;
  if (hit && !is_near(hit->weights, expected.weights)) {
    std::array<double, 3> sorted{hit->weights.x, hit->weights.y, hit->weights.z};
    std::sort(sorted.begin(), sorted.end());
    is_mixed_up = is_near({sorted[0], sorted[1], sorted[2]}, {0.2, 0.3, 0.5});
  }
  lt::diagnose(!is_mixed_up, "weights-of-other-corners",
               gave(right_angled, inside, shown(expected)));

  REQUIRE(is_right(right_angled, inside, expected));
  const Ray twice_as_fast{inside.origin, {0, 0, 2}};
  REQUIRE(is_right(right_angled, twice_as_fast, TriangleHit{1.5, expected.weights}));
  for (const Ray& outside : {beyond, left, below})
    REQUIRE(is_right(right_angled, outside, std::nullopt));
}

TEST_CASE("a triangle has two sides, and none behind the ray") {
  const Ray from_front = along_z(0.6, 0.2);
  const Ray from_back{{0.6, 0.2, 3}, {0, 0, -1}};
  const Ray leaving{{0.6, 0.2, 3}, {0, 0, 1}};
  const MaybeHit front = intersect(right_angled, from_front);
  const MaybeHit back = intersect(right_angled, from_back);
  const MaybeHit behind = intersect(right_angled, leaving);
  const TriangleHit expected{3, {0.5, 0.3, 0.2}};
  lt::diagnose(!(front && behind), "negative-t-accepted", gave(right_angled, leaving, "nothing"));
  lt::diagnose(front.has_value() == back.has_value(), "culls-back",
               gave(right_angled, front ? from_back : from_front, shown(expected)));
  REQUIRE(is_right(right_angled, from_front, expected));
  REQUIRE(is_right(right_angled, from_back, expected));
  REQUIRE(is_right(right_angled, leaving, std::nullopt));
}

TEST_CASE("a triangle the size of a micrometre is a triangle") {
  const Triangle speck{{0, 0, 0}, {2e-6, 0, 0}, {0, 1e-6, 0}};
  const Ray ray = along_z(0.6e-6, 0.2e-6);
  const MaybeHit hit = intersect(speck, ray);
  const TriangleHit expected{3, {0.5, 0.3, 0.2}};
  lt::diagnose(!(intersect(right_angled, along_z(0.6, 0.2)) && !hit), "tiny-missed",
               gave(speck, ray, shown(expected)));
  REQUIRE(is_right(speck, ray, expected));
  REQUIRE(is_right(speck, along_z(1.4e-6, 0.8e-6), std::nullopt));
}

TEST_CASE("a parallel ray misses, beside the triangle and within its plane") {
  for (const dvec3 d : {dvec3(1, 0, 0), dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(1, -1, 0)})
    for (const double z : {0.0, -1.0, 1.0}) {
      const Ray ray{dvec3(0.5, 0.25, z) - 3.0 * d, d};
      const MaybeHit hit = intersect(right_angled, ray);
      lt::diagnose(!(hit && std::isnan(hit->t)), "nan-is-a-hit",
                   gave(right_angled, ray, "nothing"));
      REQUIRE(is_right(right_angled, ray, std::nullopt));
    }
}

TEST_CASE("t and the weights name the same point, wherever the triangle is") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 300; ++i) {
      // The answer first: weights, direction and t; the ray's origin follows.
      const Triangle triangle = random_triangle(random);
      const double b1 = random.uniform(-0.3, 1.0);
      const double b2 = random.uniform(-0.3, 1.0);
      const dvec3 weights{1 - b1 - b2, b1, b2};
      const dvec3 way = random.direction();
      const double metres = random.uniform(0.1, 10) * (i % 4 == 0 ? -1 : 1);
      const double speed = std::pow(10.0, random.uniform(-1, 1));
      const double smallest = std::min({weights.x, weights.y, weights.z});
      if (std::abs(smallest) < 1e-6 || cosine_between(triangle, way) < 0.05) continue;

      const Ray ray{point_of(triangle, weights) - metres * way, speed * way};
      if (smallest > 0 && metres > 0)
        REQUIRE(is_right(triangle, ray, TriangleHit{metres / speed, weights}));
      else
        REQUIRE(is_right(triangle, ray, std::nullopt));
    }
  }
}

TEST_CASE("a grid of rays sees the triangle's outline, from both sides") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    const Triangle triangle = random_triangle(random);
    const dvec3 ahead = random.direction();
    if (cosine_between(triangle, ahead) > 0.05)
      REQUIRE(covered_share(triangle, View(ahead), 3, 20) >= 0);
  }
  // Area 1, turned away by 60 degrees: it covers half a square metre of 9.
  const double share = covered_share(right_angled, View({std::sqrt(0.75), 0, 0.5}), 1.5, 60);
  REQUIRE(share > 0);
  std::ostringstream text;
  text << "3,600 parallel rays see a triangle of 1 square metre, turned by 60 degrees, as one of "
       << std::round(share * 9 * 1000) / 1000;
  lt::measured(text.str());
}
