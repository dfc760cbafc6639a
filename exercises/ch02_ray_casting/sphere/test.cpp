#include "api.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::intersect;
using exercise::Ray;
using exercise::Sphere;
using glm::dvec3;
using glm::vec3;

constexpr float infinity = std::numeric_limits<float>::infinity();

// Where a ray meets a sphere: seen or expected. Two are equal within the larger tolerance.
struct Crossing {
  std::optional<double> t = std::nullopt;
  double tolerance = 1e-6;
};

bool operator==(const Crossing& a, const Crossing& b) {
  if (!a.t || !b.t) return a.t.has_value() == b.t.has_value();
  return std::abs(*a.t - *b.t) <= std::fmax(a.tolerance, b.tolerance);  // false for NaN
}

std::ostream& operator<<(std::ostream& out, const Crossing& crossing) {
  std::ostringstream text;  // the precision of `out` stays as it is
  text.precision(9);
  if (crossing.t) text << "a hit at t = " << *crossing.t;
  return out << (crossing.t ? text.str() : "no hit");
}

const Crossing no_hit{};

Crossing hit_at(double t, double tolerance = 1e-6) {
  return {t, tolerance};
}

Crossing seen(const Sphere& sphere, const Ray& ray, float t_min = 0.0f, float t_max = infinity) {
  const std::optional<float> t = intersect(sphere, ray, t_min, t_max);
  return t ? hit_at(*t) : no_hit;
}

const Sphere ball{vec3(0.0f), 1.0f};

// From (x, y, 0) to the right. Past the unit ball's centre it crosses at -x - 1 and -x + 1.
Ray along_x(float x, float y = 0.0f, float length = 1.0f) {
  return {{x, y, 0.0f}, {length, 0.0f, 0.0f}};
}

std::string gave(const std::string& call, const Crossing& crossing, const Crossing& expected) {
  std::ostringstream text;
  text << call << " gave " << crossing << " and should give " << expected << ".";
  return text.str();
}

// The plainest case of all. Other diagnoses mean something only where this one is right.
bool is_right_from_outside() {
  return seen(ball, along_x(-3)) == hit_at(2);
}

// A ball of 1 m, passed at `aside` from its centre, straight up and `distance` away.
Crossing straight_up(float distance, float aside) {
  return seen({{0, distance, 0}, 1}, {{aside, 0, 0}, {0, 1, 0}});
}

}  // namespace

TEST_CASE("from outside, the near crossing counts") {
  const Crossing ahead = seen(ball, along_x(-3));
  const Crossing behind = seen(ball, along_x(3));
  const std::string call = "The unit ball at 0, seen from x = -3 along +x,";
  // With the sign of b wrong, the roots 2 and 4 become -4 and -2, and for x = 3 the other way.
  lt::diagnose(!(ahead == no_hit && behind == hit_at(2)), "looks-backwards",
               gave(call, ahead, hit_at(2)));
  lt::diagnose(!(ahead == hit_at(4)), "far-side-first", gave(call, ahead, hit_at(2)));
  CHECK(seen(ball, along_x(-3)) == hit_at(2));
  // 3-4-5 triangle: at height 0.6 the ball reaches from x = -0.8 to 0.8.
  CHECK(seen(ball, along_x(-3, 0.6f)) == hit_at(2.2));
  CHECK(seen({{10, 20, 30}, 2}, {{10, 20, 25}, {0, 0, 1}}) == hit_at(3));
  CHECK(seen({{10, 20, 30}, 2}, {{10, 29, 30}, {0, -1, 0}}) == hit_at(7));
}

TEST_CASE("from inside, the way out counts") {
  const Crossing inside = seen(ball, along_x(0.5f));  // past the centre
  const Crossing before_center = seen(ball, along_x(-0.5f));
  const std::string call = "From x = 0.5 inside the unit ball, along +x, it";
  lt::diagnose(!(is_right_from_outside() && inside == no_hit && before_center == no_hit),
               "near-root-only", gave(call, inside, hit_at(0.5)));
  lt::diagnose(!(is_right_from_outside() && inside == no_hit && before_center == hit_at(1.5)),
               "center-behind", gave(call, inside, hit_at(0.5)));
  lt::diagnose(!(inside == hit_at(-1.5)), "t-min-unchecked", gave(call, inside, hit_at(0.5)));
  CHECK(seen(ball, along_x(0.5f)) == hit_at(0.5));
  CHECK(seen(ball, along_x(-0.5f)) == hit_at(1.5));
  CHECK(seen(ball, along_x(0)) == hit_at(1));
  CHECK(seen(ball, along_x(0, 0.6f)) == hit_at(0.8));
}

TEST_CASE("a ball behind the ray or beside it is a miss") {
  CHECK(seen(ball, along_x(3)) == no_hit);
  CHECK(seen(ball, along_x(1.001f)) == no_hit);
  CHECK(seen(ball, along_x(-3, 1.001f)) == no_hit);
  CHECK(seen(ball, along_x(-3, -20)) == no_hit);
}

TEST_CASE("a ray that touches the ball hits it once") {
  // All of it is exact in floats: the nearest point is (0, 1, 0), the discriminant 1 - 1 = 0.
  CHECK(seen(ball, along_x(-3, 1)) == hit_at(3));
  CHECK(seen({{5, 5, 5}, 4}, {{9, 5, -1}, {0, 0, 2}}) == hit_at(3));
}

TEST_CASE("t_min and t_max cut off what is too near and too far") {
  const Ray ray = along_x(-3);  // crosses at 2 and 4
  const Crossing later = seen(ball, ray, 3);
  const std::string call = "A ray with crossings at 2 and 4, asked with t_min = 3,";
  lt::diagnose(!(is_right_from_outside() && later == hit_at(2)), "t-min-unchecked",
               gave(call, later, hit_at(4)));
  lt::diagnose(
      !(is_right_from_outside() && seen(ball, along_x(0.5f)) == hit_at(0.5) && later == no_hit),
      "chosen-too-early", gave(call, later, hit_at(4)));
  CHECK(seen(ball, ray, 3) == hit_at(4));
  CHECK(seen(ball, ray, 0, 3) == hit_at(2));
  CHECK(seen(ball, ray, 0, 1) == no_hit);
  CHECK(seen(ball, ray, 3, 3.5f) == no_hit);
  CHECK(seen(ball, ray, 5) == no_hit);
  CHECK(seen(ball, along_x(0.5f), 0, 0.25f) == no_hit);
  // The ends do not count. All of it is exact in floats.
  CHECK(seen(ball, ray, 0, 2) == no_hit);
  CHECK(seen(ball, ray, 2) == hit_at(4));
  CHECK(seen(ball, ray, 2, 4) == no_hit);
}

TEST_CASE("from a point of the surface, the other side counts") {
  CHECK(seen(ball, along_x(-1), 1e-3f) == hit_at(2));
  CHECK(seen(ball, along_x(1), 1e-3f) == no_hit);
}

TEST_CASE("t counts in lengths of the direction") {
  const Crossing longer = seen(ball, along_x(-3, 0, 3));  // at distance 2, which is 2/3 of 3
  const std::string call = "With direction (3, 0, 0) from x = -3 it";
  lt::diagnose(!(is_right_from_outside() && longer == hit_at(2)), "distance-for-t",
               gave(call, longer, hit_at(2.0 / 3)));
  lt::diagnose(!(is_right_from_outside() && !(longer == hit_at(2.0 / 3))), "assumes-unit-d",
               gave(call, longer, hit_at(2.0 / 3)));
  // Floats near 17.6 are 2e-6 apart: room for some fifty roundings.
  const Crossing expected = hit_at(17.6, 1e-4);
  const Crossing shorter = seen(ball, along_x(-3, 0.6f, 0.125f));
  const bool is_unit_right = seen(ball, along_x(-3, 0.6f)) == hit_at(2.2);
  lt::diagnose(!(is_unit_right && longer == hit_at(2.0 / 3) && !(shorter == expected)),
               "assumes-unit-d",
               gave("With direction (0.125, 0, 0) from (-3, 0.6, 0) it", shorter, expected));
  CHECK(seen(ball, along_x(-3, 0, 3)) == hit_at(2.0 / 3));
  CHECK(seen(ball, along_x(-3, 0.6f, 3)) == hit_at(2.2 / 3));
  CHECK(seen(ball, along_x(-3, 0.6f, 0.125f)) == expected);
  CHECK(seen(ball, along_x(0.5f, 0, 0.25f)) == hit_at(2));
  // So do the ends: crossings at 2/3 and 4/3.
  CHECK(seen(ball, along_x(-3, 0, 3), 0, 1) == hit_at(2.0 / 3));
  CHECK(seen(ball, along_x(-3, 0, 3), 1) == hit_at(4.0 / 3));
  CHECK(seen(ball, along_x(-3, 0, 3), 1.5f) == no_hit);
}

TEST_CASE("a ball of radius 1 at a distance of a million is hit and missed where it should be") {
  // Passed at 0.5 the ball is crossed sqrt(0.75) before its centre. Floats near 10^6 are 1/16
  // apart. The school formula cannot tell 10^12 + 0.25 - 1 from 10^12 and gives 10^6, or is off by
  // the root of some 65,536, or misses; and at 2 from the centre it does the same.
  const Crossing crossing = hit_at(1e6 - std::sqrt(0.75), 1.0 / 8);
  const Crossing far_away = straight_up(1e6f, 0.5f);
  const Crossing past = straight_up(1e6f, 2.0f);
  const bool is_right_nearby =
      straight_up(10, 0.5f) == hit_at(10 - std::sqrt(0.75), 1e-5) && straight_up(10, 2) == no_hit;
  lt::diagnose(!(is_right_nearby && !(far_away == crossing)), "school-formula",
               gave("Passed at 0.5 from the centre, at 10^6 it", far_away, crossing));
  lt::diagnose(!(is_right_nearby && !(past == no_hit)), "school-formula",
               gave("Passed at 2 from the centre, at 10^6 it", past, no_hit));
  CHECK(straight_up(1e6f, 0.5f) == crossing);
  CHECK(straight_up(1e6f, 2) == no_hit);
  CHECK(straight_up(1e6f, 1.01f) == no_hit);
  std::ostringstream text;
  text.precision(9);
  text << "a ball of 1 m, 1,000 km away, is hit after " << far_away.t.value_or(0)
       << " m; exact is 999999.134 m, and floats there are 1/16 m apart";
  lt::measured(text.str());
}

TEST_CASE("rays through two known points of a random ball find them") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 60; ++i) {
      const double radius = std::pow(10.0, random.uniform(-2, 2));
      const dvec3 center = radius * random.uniform(0, 5) * random.direction();
      const dvec3 p = center + radius * random.direction();
      const dvec3 q = center + radius * random.direction();
      // The origin lies on the line, `start` chords before p: before the ball, in it, or behind it.
      const double start = random.uniform(-2, 10);
      const double chord = glm::distance(p, q);
      const bool is_at_surface = std::abs(start) < 0.05 || std::abs(start + 1) < 0.05;
      if (chord < 0.5 * radius || is_at_surface) continue;  // no rim: there, anything may happen
      const double length = std::pow(10.0, random.uniform(-1, 1));  // of d, in chords
      const dvec3 origin = p - start * (q - p);
      const Sphere sphere{vec3(center), static_cast<float>(radius)};
      const Ray ray{vec3(origin), vec3(length * (q - p))};

      // With u = 2^-24 the stable forms, and rounding what they get to floats, move the surface by
      // some 20 u of all lengths that meet there; along the ray that is 1 / cosine longer. Three
      // times that is room for other orders of summing. The chord is 2 radius cosine.
      const double lengths =
          glm::length(origin) + glm::length(center) + radius + glm::distance(origin, center);
      const double tolerance = 64 * 0x1p-24 * lengths / (chord / 2 / radius) / (length * chord);
      const Crossing entry = hit_at(start / length, tolerance);
      const Crossing exit = hit_at((start + 1) / length, tolerance);
      const auto middle = static_cast<float>((start + 0.5) / length);
      INFO("ball " << i << ", direction " << length * chord << " long");
      REQUIRE(seen(sphere, ray) == (start > 0 ? entry : start > -1 ? exit : no_hit));
      if (start < 0) continue;
      REQUIRE(seen(sphere, ray, middle) == exit);
      REQUIRE(seen(sphere, ray, 0, middle) == entry);
      REQUIRE(seen(sphere, ray, 0, 0.9f * static_cast<float>(start / length)) == no_hit);
    }
  }
}

TEST_CASE("rays that pass a random ball miss it") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 60; ++i) {
      const double radius = std::pow(10.0, random.uniform(-2, 2));
      const dvec3 center = radius * random.uniform(0, 5) * random.direction();
      const dvec3 direction = random.direction();
      const dvec3 aside = glm::normalize(glm::cross(direction, random.direction()));
      const double distance = random.uniform(1.02, 4);
      const dvec3 origin = center + radius * (distance * aside - random.uniform(0, 10) * direction);
      INFO("ball " << i << ", passed at " << distance << " radii from its centre");
      const Ray ray{vec3(origin), vec3(random.uniform(0.2, 5) * direction)};
      REQUIRE(seen({vec3(center), static_cast<float>(radius)}, ray) == no_hit);
    }
  }
}
