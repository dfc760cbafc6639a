#include "api.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::refracted;
using glm::dvec3;
using lt::text_of;
using std::numbers::pi;
using MaybeDirection = std::optional<dvec3>;

// A ray that meets a surface.
struct Case {
  dvec3 wo, normal;
  double n_outside, n_inside;
};

// From angles, about an axis across the plane of wo and normal.
MaybeDirection right(const Case& c) {
  const bool is_outside = dot(c.wo, c.normal) > 0;
  const dvec3 h = is_outside ? c.normal : -c.normal;
  const double eta = is_outside ? c.n_outside / c.n_inside : c.n_inside / c.n_outside;
  const double sine = length(cross(c.wo, h));
  if (eta * sine >= 1) return std::nullopt;
  if (sine == 0) return -c.wo;
  const double beyond = std::asin(eta * sine);
  const dvec3 along = cross(h, cross(c.wo, h)) / sine;
  return -std::sin(beyond) * along - std::cos(beyond) * h;
}

MaybeDirection answer(const Case& c) {
  return refracted(c.wo, c.normal, c.n_outside, c.n_inside);
}

// No direction and one that is not a number are alike here: what is beyond a root has two looks.
bool is_nothing(const MaybeDirection& w) {
  return !w || std::isnan(w->x) || std::isnan(w->y) || std::isnan(w->z);
}
bool is_same(const MaybeDirection& a, const MaybeDirection& b) {
  if (is_nothing(a) || is_nothing(b)) return is_nothing(a) && is_nothing(b);
  return distance(*a, *b) < 1e-9;
}

std::string shown(dvec3 v) {
  return text_of(v + 0.0);  // "-0" says no more than "0"
}
std::string shown(const MaybeDirection& w) {
  if (!w) return "nothing";
  std::string text = shown(*w);
  if (std::abs(length(*w) - 1) > 1e-9) text += " (" + text_of(length(*w)) + " long)";
  return text;
}
std::string gave(const Case& c) {
  const MaybeDirection value = answer(c);
  const MaybeDirection expected = right(c);
  std::string text = "wo " + shown(c.wo) + ", normal " + shown(c.normal) + ", index " +
                     text_of(c.n_outside) + " outside and " + text_of(c.n_inside) +
                     " inside: gave " + shown(value) + " and should give " + shown(expected) + '.';
  if (value && expected && distance(*value, *expected) < 1e-4)
    text += " That is off by " + text_of(distance(*value, *expected)) + '.';
  return text;
}
bool is_right(const Case& c) {
  const bool is_so = is_same(answer(c), right(c)) && answer(c).has_value() == right(c).has_value();
  if (!is_so) UNSCOPED_INFO(gave(c));
  return is_so;
}

// With few digits. The first four come from outside; none is reflected completely.
const dvec3 up{0, 1, 0}, slanted{0.48, 0.6, 0.64}, askew{0.36, 0.8, -0.48};
const std::array<Case, 7> cases{{
    {{0.6, 0.8, 0}, up, 1, 1.5},
    {{-0.8, 0.6, 0}, up, 1, 1.33},
    {{0, 0.6, 0.8}, slanted, 1, 1.5},
    {{0, 0.28, -0.96}, askew, 1.2, 2.4},
    {{0.28, -0.96, 0}, up, 1, 1.5},
    {{0, -0.936, 0.352}, up, 1, 1.33},
    {{-0.48, -0.8, -0.36}, slanted, 1, 1.05},
}};

// What a formula of this side's normal, wo's cosine to it and the ratio gives.
using Formula = std::function<MaybeDirection(dvec3 wo, dvec3 h, double c, double eta)>;
// Which normal and ratio a mistaken answer may put in.
enum class Side { found, normal_not_flipped, indices_not_swapped, ignored };
MaybeDirection by(const Formula& formula, Side side, const Case& c) {
  const bool is_outside = dot(c.wo, c.normal) > 0;
  const bool keeps_normal = side == Side::normal_not_flipped || side == Side::ignored;
  const bool keeps_ratio = side == Side::indices_not_swapped || side == Side::ignored;
  const dvec3 h = is_outside || keeps_normal ? c.normal : -c.normal;
  const double eta = c.n_outside / c.n_inside;
  return formula(c.wo, h, dot(c.wo, h), is_outside || keeps_ratio ? eta : 1 / eta);
}
MaybeDirection snell(dvec3 wo, dvec3 h, double c, double eta) {
  return (eta * c - std::sqrt(1 - eta * eta * (1 - c * c))) * h - eta * wo;
}
double root(double c, double eta) {
  return std::sqrt(1 - eta * eta * (1 - c * c));
}
MaybeDirection misprinted(dvec3 wo, dvec3 h, double c, double eta) {
  return (eta * c - std::sqrt(1 - eta * (1 - c * c))) * h - eta * wo;
}

struct Mistake {
  const char* tag;
  Formula formula;
  Side side = Side::found;
};
const std::array<Mistake, 16> mistakes{{
    {"normal-not-flipped", snell, Side::normal_not_flipped},
    {"indices-not-swapped", snell, Side::indices_not_swapped},
    {"side-ignored", snell, Side::ignored},
    {"eta-inverted",
     [](dvec3 wo, dvec3 h, double c, double eta) { return snell(wo, h, c, 1 / eta); }},
    {"eta-not-squared", misprinted},
    {"eta-not-squared",  // made 1 long afterwards
     [](dvec3 wo, dvec3 h, double c, double eta) { return normalize(*misprinted(wo, h, c, eta)); }},
    {"wo-not-turned",
     [](dvec3 wo, dvec3 h, double c, double eta) { return eta * (wo - c * h) - root(c, eta) * h; }},
    {"cosine-for-sine",
     [](dvec3 wo, dvec3 h, double c, double eta) {
       return (eta * c - std::sqrt(1 - eta * eta * c * c)) * h - eta * wo;
     }},
    {"root-forgotten",
     [](dvec3 wo, dvec3 h, double c, double eta) {
       return (eta * c - root(c, eta) * root(c, eta)) * h - eta * wo;
     }},
    {"root-added", [](dvec3 wo, dvec3 h, double c,
                      double eta) { return (eta * c + root(c, eta)) * h - eta * wo; }},
    {"tangent-not-scaled",
     [](dvec3 wo, dvec3 h, double c, double eta) { return (c - root(c, eta)) * h - wo; }},
    {"tangent-not-scaled",  // made 1 long afterwards
     [](dvec3 wo, dvec3 h, double c, double eta) {
       return normalize((c - root(c, eta)) * h - wo);
     }},
    {"straight-through", [](dvec3 wo, dvec3, double, double) { return -wo; }},
    {"mirrored", [](dvec3 wo, dvec3 h, double c, double) { return 2 * c * h - wo; }},
    {"angle-for-sine",
     [](dvec3 wo, dvec3 h, double c, double eta) {
       const double beyond = eta * std::acos(c);
       return -std::sin(beyond) * normalize(wo - c * h) - std::cos(beyond) * h;
     }},
    {"angle-for-sine",
     [](dvec3 wo, dvec3 h, double c, double eta) {
       const double beyond = std::acos(c) / eta;
       return -std::sin(beyond) * normalize(wo - c * h) - std::cos(beyond) * h;
     }},
}};

}  // namespace

TEST_CASE("a ray is bent by Snell's law, from outside and from inside") {
  for (const auto& [tag, formula, side] : mistakes) {
    bool is_it = true;
    const Case* example = nullptr;  // where it shows
    for (const Case& c : cases) {
      is_it = is_it && is_same(answer(c), by(formula, side, c));
      if (!example && !is_same(answer(c), right(c))) example = &c;
    }
    if (example) lt::diagnose(!is_it, tag, gave(*example));
  }
  for (const Case& c : cases)
    REQUIRE(is_right(c));
  for (const dvec3 n : {up, slanted})
    for (const dvec3 wo : {n, -n}) {
      INFO("Along the normal a ray goes straight on.");
      REQUIRE(is_right({wo, n, 1, 1.5}));
    }
  INFO("With equal indices a ray goes straight on.");
  REQUIRE(is_right({{0.6, 0.8, 0}, up, 1.5, 1.5}));
  REQUIRE(is_right({{0, -0.28, 0.96}, up, 1.33, 1.33}));
}

TEST_CASE("beyond the critical angle no ray gets through") {
  // From glass to air that is 41.81 degrees; from air into a bubble of index 1/1.5 as well.
  for (const double degrees : {42.0, 60.0, 85.0})
    for (const bool is_inside : {true, false}) {
      const double theta = degrees * pi / 180;
      const dvec3 h = is_inside ? -up : up;
      const Case c{{std::sin(theta), std::cos(theta) * h.y, 0},
                   up,
                   is_inside ? 1 : 1.5,
                   is_inside ? 1.5 : 1};
      const MaybeDirection value = answer(c);
      if (!value) continue;
      const dvec3 reflected = 2 * dot(c.wo, h) * h - c.wo;
      const std::string seen = "At " + text_of(degrees) + " degrees, " + gave(c);
      lt::diagnose(!is_nothing(value), "nan-beyond-critical", seen);
      // Only who is right before the critical angle; others have been named already.
      if (!is_same(answer(cases[0]), right(cases[0]))) continue;
      if (!is_same(answer(cases[4]), right(cases[4]))) continue;
      lt::diagnose(length(*value) > 1e-9, "null-beyond-critical", seen);
      lt::diagnose(distance(*value, reflected) > 1e-9, "reflected-beyond-critical", seen);
      lt::diagnose(std::abs(value->y) > 1e-9 || value->x >= 0, "clamped-at-zero", seen);
      FAIL(seen);
    }
  // Half a degree before it the ray is there.
  for (const double degrees : {41.3, 41.8})
    REQUIRE(
        is_right({{std::sin(degrees * pi / 180), -std::cos(degrees * pi / 180), 0}, up, 1, 1.5}));
}

TEST_CASE("at random surfaces: unit, by Snell, and the way back leads to wo") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 200; ++i) {
      const Case c{random.direction(), random.direction(), random.uniform(0.5, 2.5),
                   random.uniform(0.5, 2.5)};
      const double cosine = dot(c.wo, c.normal);
      const double here = cosine > 0 ? c.n_outside : c.n_inside;
      const double beyond = cosine > 0 ? c.n_inside : c.n_outside;
      const double sine = here / beyond * length(cross(c.wo, c.normal));
      // Next to the edges, a last digit of wo decides.
      if (std::abs(sine - 1) < 1e-4 || std::abs(cosine) < 1e-4) continue;
      REQUIRE(is_right(c));
      if (sine > 1) continue;
      const dvec3 wi = *answer(c);
      INFO(gave(c));
      CHECK(std::abs(length(wi) - 1) < 1e-12);
      CHECK(dot(wi, c.normal) * cosine < 0);
      // All in one plane, and the sines as Snell says: the cross products are opposite.
      const double residual = length(here * cross(c.wo, c.normal) + beyond * cross(wi, c.normal));
      INFO("n sin(theta) differs by " << residual << " between both sides.");
      CHECK(residual < 1e-12);
      const MaybeDirection back = refracted(wi, c.normal, c.n_outside, c.n_inside);
      INFO("The way back leads to " << shown(back) << '.');
      CHECK((back && distance(*back, c.wo) < 1e-9));
    }
  }
  const dvec3 wi = *refracted({std::sin(pi / 4), std::cos(pi / 4), 0}, up, 1, 1.5);
  lt::measured("a ray at 45 degrees runs on at " + text_of(std::acos(-wi.y) * 180 / pi) +
               " degrees in glass; out of glass, none beyond 41.81 degrees gets through");
}
