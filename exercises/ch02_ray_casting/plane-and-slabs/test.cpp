#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::Box;
using exercise::intersect;
using exercise::Plane;
using exercise::Ray;
using glm::dvec3;
using MaybeT = std::optional<double>;

// Two, four and eight metres long; all numbers are exact.
const Box box{{2, -1, -6}, {4, 3, 2}};
const dvec3 middle{3, 1, -2}, half{1, 2, 4};

std::string shown(dvec3 v) {
  std::ostringstream text;
  text.precision(10);  // enough to see what float arithmetic loses
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

std::string shown(const MaybeT& t) {
  std::ostringstream text;
  text.precision(10);
  if (t) text << "t = " << (std::isnan(*t) ? std::abs(*t) : *t + 0.0);
  return t ? text.str() : "nothing";
}

std::string shown(const Box& that) {
  return "box from " + shown(that.lower) + " to " + shown(that.upper);
}

std::string shown(const Plane& that) {
  return "plane through " + shown(that.point) + " across " + shown(that.normal);
}

// A question and the answer, known beforehand.
struct Case {
  Ray ray;
  MaybeT t;
};
using Cases = std::vector<Case>;

Cases wrong(const auto& shape, const Cases& cases) {
  Cases left;
  for (const Case& one : cases) {
    const MaybeT t = intersect(shape, one.ray);
    const bool is_near = t && one.t && std::abs(*t - *one.t) <= 1e-9;  // false for NaN
    if (!is_near && (t || one.t)) left.push_back(one);
  }
  return left;
}

// What the first wrong answer was.
std::string seen(const auto& shape, const Cases& cases) {
  for (const auto& [ray, t] : wrong(shape, cases))
    return "gave " + shown(intersect(shape, ray)) + " and should give " + shown(t) +
           ": the ray from " + shown(ray.origin) + " along " + shown(ray.direction) + " at the " +
           shown(shape) + ".";
  return "";
}

bool all_right(const auto& shape, const Cases& cases) {
  const std::string complaint = seen(shape, cases);
  if (!complaint.empty()) UNSCOPED_INFO(complaint);
  return complaint.empty();
}

// From the middle of a cube to its 6 faces, 12 edges and 8 corners, in this order.
std::vector<dvec3> cube_directions() {
  std::vector<dvec3> all;
  for (const double square : {1, 2, 3})
    for (int i = 0; i < 27; ++i) {
      const dvec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      if (dot(d, d) == square) all.push_back(d);
    }
  return all;
}

// When a ray from the middle leaves the box: through the nearest face that it moves to.
double exit_from_middle(dvec3 d) {
  const dvec3 way = glm::mix(dvec3(1e9), half, glm::notEqual(d, dvec3(0)));
  return std::min({way.x, way.y, way.z});
}

// From `start` steps beyond the middle: -8 is before the box, 0 in it, 8 behind it.
Cases through_middle(double start) {
  Cases cases;
  for (const dvec3 d : cube_directions()) {
    const double enter = -start - exit_from_middle(d);
    const double exit = -start + exit_from_middle(d);
    const MaybeT expected = exit > 0 ? MaybeT(enter > 0 ? enter : exit) : std::nullopt;
    cases.push_back({{middle + start * d, d}, expected});
  }
  return cases;
}

// From the middle of each face: inwards, outwards and along it.
Cases from_faces() {
  Cases cases;
  for (const dvec3 d : cube_directions())
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        dvec3 origin = middle;
        origin[axis] += side * half[axis];
        dvec3 others = d;
        others[axis] = 0;
        MaybeT exit = exit_from_middle(others);
        if (d[axis] * side < 0) exit = std::min(*exit, 2 * half[axis]);
        if (d[axis] * side > 0) exit.reset();
        cases.push_back({{origin, d}, exit});
      }
  return cases;
}

// From one metre outside along each axis, at `height` half lengths above the middle on another.
Cases along_axes(double height, double zero, MaybeT expected = 1.0) {
  Cases cases;
  for (int across = 0; across < 3; ++across)
    for (const int along : {(across + 1) % 3, (across + 2) % 3})
      for (const int way : {1, -1}) {
        dvec3 origin = middle;
        dvec3 d(zero);
        origin[across] += height * half[across];
        origin[along] -= way * (half[along] + 1);
        d[along] = way;
        cases.push_back({{origin, d}, expected});
      }
  return cases;
}

// The answer first: a point of a face, and the ways to it from outside and from inside.
Cases hits(lt::TestRandom& random, const Box& that) {
  dvec3 target = glm::mix(that.lower, that.upper, 0.5 + 0.49 * random.direction());
  dvec3 start = glm::mix(that.lower, that.upper, 0.5 + 0.49 * random.direction());
  const int axis = static_cast<int>(random.next_bits() % 3);
  const bool is_upper = random.uniform() < 0.5;
  target[axis] = is_upper ? that.upper[axis] : that.lower[axis];
  dvec3 d = random.direction();
  d[axis] = (is_upper ? -1 : 1) * (std::abs(d[axis]) + 0.05);
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3})
    if (random.uniform() < 0.3) {
      d[other] = random.uniform() < 0.5 ? 0.0 : -0.0;
      start[other] = target[other];
    }
  const double t = random.uniform(0.1, 10);
  const dvec3 origin = target - t * d;
  return {{{origin, 3.0 * d}, t / 3},
          {{origin, -d}, std::nullopt},
          {{start, 2.0 * (target - start)}, 0.5}};
}

// A plane that touches the box at a corner or more, and a ray in a parallel plane, farther out.
Cases misses(lt::TestRandom& random, const Box& that) {
  dvec3 out = random.direction();
  if (random.uniform() < 0.5) out = cube_directions()[random.next_bits() % 6];
  const dvec3 corner = glm::mix(that.lower, that.upper, glm::step(dvec3(0), out));
  const dvec3 d = normalize(cross(out, random.direction()));
  const dvec3 origin = corner + random.uniform(0.01, 1) * out + random.uniform(-5, 5) * d;
  return {{{origin, d}, std::nullopt}};
}

}  // namespace

TEST_CASE("a plane is met from above and from below, ahead of the ray, and never along it") {
  const Plane floor{{5, -2, 7}, {0, 1, 0}};
  const Cases ahead{{{{0, 1, 0}, {1, -1, 0}}, 3.0}, {{{0, -4, 0}, {0, 0.5, 3}}, 4.0}};
  const Cases behind{{{{0, 1, 0}, {1, 1, 0}}, {}}, {{{0, -4, 0}, {0, -0.5, 3}}, {}}};
  lt::diagnose(!(wrong(floor, ahead).empty() && wrong(floor, behind).size() == 2), "plane-behind",
               seen(floor, behind));
  REQUIRE(all_right(floor, ahead));
  REQUIRE(all_right(floor, behind));
  for (const double height : {1.0, -4.0, -2.0})  // above, below and within it
    for (const dvec3 d : {dvec3(1, 0, 0), dvec3(0, -0.0, -2), dvec3(-1, 0, 3)}) {
      const Cases level{{{{0, height, 0}, d}, std::nullopt}};
      lt::diagnose(std::isfinite(intersect(floor, level[0].ray).value_or(0)),
                   "parallel-at-infinity", seen(floor, level));
      REQUIRE(all_right(floor, level));
    }
}

TEST_CASE("a box is met from all 26 sides, from inside and from its faces, but not behind") {
  const Cases outside = through_middle(-8);
  const Cases inside = through_middle(0);
  const Cases leaving = through_middle(8);
  Cases up, down;
  for (const Case& one : outside)
    (glm::any(glm::lessThan(one.ray.direction, dvec3(0))) ? down : up).push_back(one);
  lt::diagnose(!(wrong(box, up).empty() && wrong(box, down).size() == 19), "no-swap-for-negative-d",
               seen(box, down));
  REQUIRE(all_right(box, outside));
  lt::diagnose(wrong(box, inside).size() < 26, "inside-forgotten", seen(box, inside));
  REQUIRE(all_right(box, inside));
  lt::diagnose(wrong(box, leaving).size() < 26, "box-behind", seen(box, leaving));
  REQUIRE(all_right(box, leaving));
  for (const Case& one : from_faces())
    lt::diagnose(intersect(box, one.ray) != 0.0, "start-counts", seen(box, {one}));
  REQUIRE(all_right(box, from_faces()));
}

TEST_CASE("a ray may run along in a face, and 0 may be -0") {
  const Cases minus_zero = along_axes(0.5, -0.0);
  const Cases beside = along_axes(2.0, 0.0, std::nullopt);
  REQUIRE(all_right(box, along_axes(0.5, 0.0)));
  lt::diagnose(wrong(box, beside).empty(), "zero-skipped", seen(box, beside));
  for (const Cases& in_face : {along_axes(-1, 0.0), along_axes(1, 0.0)})
    lt::diagnose(wrong(box, in_face).empty(), "zero-times-infinity", seen(box, in_face));
  lt::diagnose(wrong(box, minus_zero).empty(), "minus-zero", seen(box, minus_zero));
  for (const double side : {-1.0, 1.0})
    REQUIRE(all_right(box, along_axes(side, -0.0)));
}

TEST_CASE("a flat box is met too") {
  const Box lid{{2, 3, -6}, {4, 3, 2}};                   // nothing but the top of `box`
  const Cases onto{{{{2.5, 4, -3}, {0.5, -1, 1}}, 1.0}};  // to (3, 3, -2)
  REQUIRE(all_right(box, onto));
  lt::diagnose(intersect(lid, onto[0].ray).has_value(), "flat-box-missed", seen(lid, onto));
  REQUIRE(all_right(lid, {onto[0], {{{3, 4, -2}, {2, -1, 0}}, std::nullopt}}));
}

TEST_CASE("any plane and any box are met where they are") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      // The answer first: a point of the plane, one metre before or behind the ray's origin.
      const dvec3 normal = random.direction();
      const dvec3 target = 3.0 * random.direction();
      const Plane plane{target + 3.0 * cross(normal, random.direction()), normal};
      const dvec3 way = random.direction();
      if (std::abs(dot(way, normal)) > 0.05)
        REQUIRE(all_right(plane, {{{target - way, 2.0 * way}, 0.5},  //
                                  {{target + way, 2.0 * way}, {}}}));
      const dvec3 lower = 3.0 * random.direction();
      const Box that{lower, lower + 0.1 + 4.0 * glm::abs(random.direction())};
      REQUIRE(all_right(that, hits(random, that)));
      REQUIRE(all_right(that, misses(random, that)));
    }
  }
  lt::measured("18 of the 26 directions have components of 0, and no answer was NaN");
}
