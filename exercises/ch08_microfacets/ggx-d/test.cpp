#include "api.hpp"
#include "formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::brushed_ggx_d;
using exercise::ggx_d;
using exercise::ggx_d_between;
using glm::vec2;
using lt::text_of;
using namespace oracle;

std::string text_of(vec2 v) {
  return '(' + text_of(v.x) + ", " + text_of(v.y) + ')';
}
std::string text_of(vec3 v) {
  return text_of(glm::dvec3(v));
}
template <class First, class... More>
std::string call(const std::string& name, First first, More... more) {
  return name + '(' + text_of(first) + (... + (", " + text_of(more))) + ')';
}
std::string gave(const std::string& what, double value, double right) {
  return what + " gave " + text_of(value) + " and should give " + text_of(right) + '.';
}
bool is_right(const std::string& what, double value, double right, double relative = 1e-4) {
  if (!is_near(value, right, relative)) UNSCOPED_INFO(gave(what, value, right));
  return is_near(value, right, relative);
}

std::string d_gave(float alpha, vec3 h) {
  return gave(call("ggx_d", alpha, h), ggx_d(alpha, h), expected(alpha, h));
}
bool d_is_right(float alpha, vec3 h) {
  return is_right(call("ggx_d", alpha, h), ggx_d(alpha, h), expected(alpha, h));
}

// Normals with few digits, 16 to 61 degrees from straight up.
const vec3 first{0.48f, 0.36f, 0.8f};
const std::array<vec3, 5> normals{{first,
                                   {0, 0.8f, 0.6f},
                                   {-0.168f, 0.224f, 0.96f},
                                   {-0.48f, 0.64f, 0.6f},
                                   {0.6f, 0.64f, 0.48f}}};

// Does ggx_d() give what this formula gives, everywhere?
bool is(Formula formula) {
  for (const float alpha : {0.1f, 0.3f, 0.5f})
    for (const vec3 h : normals)
      if (!is_near(ggx_d(alpha, h), formula(alpha, h))) return false;
  return true;
}

// Where this is false, a mistake has been named already and must not pass for another one.
bool is_right_in_the_middle() {
  return is(expected);
}

const vec2 widths{0.2f, 0.5f};
bool brushed_is(Brushed formula) {
  return std::ranges::all_of(
      normals, [&](vec3 h) { return is_near(brushed_ggx_d(widths, h), formula(widths, h)); });
}

std::string brushed_gave(vec2 alphas, vec3 h) {
  return gave(call("brushed_ggx_d", alphas, h), brushed_ggx_d(alphas, h),
              expected(dvec2(alphas), h));
}
bool brushed_is_right(vec2 alphas, vec3 h, vec3 like) {
  return is_right(call("brushed_ggx_d", alphas, h), brushed_ggx_d(alphas, h),
                  expected(dvec2(alphas), like));
}

// A facet that leans by 1e-4: the z of its normal is 1 in float. And facets that lean no farther
// than float can tell from level.
const vec3 leaning{0.6e-4f, 0.8e-4f, 1}, level{0.6f, 0.8f, 0};
const std::array<vec3, 3> next_to_level{{level, {0, 1, 1e-12f}, {0, 1, 1e-30f}}};

// Right; of a level facet, neither infinite nor NaN.
bool holds(vec3 h, double value, double right) {
  return is_near(value, right) || (h.z == 0 && std::isfinite(value));
}

// The integral of f over the directions of the upper half, up to the angle `end`.
double sum(const std::function<double(vec3 h)>& f, double end = std::acos(0.0)) {
  constexpr int turns = 48;  // evenly spread angles: exact but for their 48th harmonic
  return lt::integrate(
      [&](double theta) {
        double ring = 0;
        for (int i = 0; i < turns; ++i) {
          const double phi = 2 * pi * (i + 0.5) / turns;
          ring += f(vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                         std::cos(theta)));
        }
        return ring * 2 * pi / turns * std::sin(theta);
      },
      0, end, 1e-5);
}

}  // namespace

TEST_CASE("ggx_d is the area of the facets that face h") {
  for (const auto& [tag, formula] : mistakes)
    lt::diagnose(!is(formula), tag, d_gave(0.3f, first));
  for (const float alpha : {0.1f, 0.3f, 0.5f, 1.0f})
    for (const vec3 h : normals)
      REQUIRE(d_is_right(alpha, h));
  for (const vec3 h : {vec3(0.6f, 0, -0.8f), vec3(0, 0, -1)})
    lt::diagnose(ggx_d(0.3f, h) == 0, "faces-down", d_gave(0.3f, h));
}

TEST_CASE("ggx_d holds where float has few digits") {
  if (is_right_in_the_middle()) {
    lt::diagnose(is_near(ggx_d(1e-4f, leaning), expected(1e-4f, leaning), 0.01), "digits-cancelled",
                 d_gave(1e-4f, leaning));
    for (const vec3 h : next_to_level)
      lt::diagnose(holds(h, ggx_d(0.5f, h), expected(0.5f, h)), "lost-at-the-horizon",
                   d_gave(0.5f, h));
  }
  for (const vec3 h : {vec3(0, 0, 1), leaning})
    REQUIRE(d_is_right(1e-4f, h));
  REQUIRE(d_is_right(0.5f, level));
}

TEST_CASE("the facets, seen from straight above, cover the surface once") {
  for (const float alpha : {1.0f, 0.3f, 0.05f}) {
    const auto seen_area = [&](vec3 h) { return ggx_d(alpha, h) * h.z; };
    INFO("Times the cosine, for alpha " << alpha << ", in sum and up to the angle atan(alpha):");
    REQUIRE(is_right("ggx_d", sum(seen_area), 1, 1e-3));
    REQUIRE(is_right("ggx_d", sum(seen_area, std::atan(alpha)), 0.5, 1e-3));
  }
  const double half = sum([](vec3 h) { return ggx_d(0.3f, h) * h.z; }, std::atan(0.3));
  lt::measured("seen from straight above, " + text_of(100 * half) +
               " % of a surface lean by less than the angle whose tangent is "
               "alpha: for alpha 0.3 that is 16.7 degrees");
}

TEST_CASE("brushed_ggx_d has a width for each axis") {
  for (const auto& [tag, formula] : brushed_mistakes)
    lt::diagnose(!brushed_is(formula), tag, brushed_gave(widths, first));
  for (const vec3 h : normals)
    for (const vec3 turned : {h, vec3(-h.x, h.y, h.z), vec3(h.x, -h.y, h.z)})
      REQUIRE(brushed_is_right(widths, turned, h));
  const vec3 below{0.6f, 0, -0.8f};
  lt::diagnose(brushed_ggx_d(widths, below) == 0, "faces-down", brushed_gave(widths, below));
  const double whole = sum([](vec3 h) { return brushed_ggx_d({0.1f, 0.5f}, h) * h.z; });
  REQUIRE(is_right("The sum of brushed_ggx_d times the cosine for (0.1, 0.5)", whole, 1, 1e-3));
}

TEST_CASE("brushed_ggx_d holds where float has few digits") {
  const vec3 up{0, 0, 1};
  const vec2 narrow{1e-4f, 1e-4f};
  if (brushed_is(expected)) {
    lt::diagnose(!std::isnan(brushed_ggx_d(widths, up)), "nan-straight-up",
                 brushed_gave(widths, up));
    lt::diagnose(is_near(brushed_ggx_d(narrow, leaning), expected(dvec2(narrow), leaning), 0.01),
                 "brushed-digits-cancelled", brushed_gave(narrow, leaning));
    for (const vec3 h : next_to_level)
      lt::diagnose(holds(h, brushed_ggx_d(widths, h), expected(dvec2(widths), h)),
                   "brushed-lost-at-the-horizon", brushed_gave(widths, h));
  }
  for (const vec2 alphas : {narrow, widths, vec2(1e-4f, 0.5f), vec2(0.5f, 1e-4f)})
    for (const vec3 h : {up, leaning, level})
      REQUIRE(brushed_is_right(alphas, h, h));
}

TEST_CASE("ggx_d_between asks for the facets half-way between") {
  const vec3 wo{0.6f, 0, 0.8f}, wi{0, 0.8f, 0.6f};
  const double value = ggx_d_between(0.3f, wo, wi);
  const double right = expected(0.3f, normalize(wo + wi));
  const std::string what = call("ggx_d_between", 0.3f, wo, wi);
  const std::array<std::pair<const char*, vec3>, 5> wrong_normals{
      {{"cosine-from-wi", wi},
       {"cosine-from-wo", wo},
       {"half-not-unit", wo + wi},
       {"half-not-unit", (wo + wi) / 2.f},
       {"difference", normalize(wo - wi)}}};
  // A wrong ggx_d() has been named already and must not pass for another mistake.
  const vec3 half = normalize(wo + wi);
  const double d = ggx_d(0.3f, half);
  if (!is_near(value, d)) {
    for (const auto& [tag, h] : wrong_normals)
      lt::diagnose(!is_near(value, ggx_d(0.3f, h)), tag, gave(what, value, right));
    for (const double cosine : {1.f, half.z})
      lt::diagnose(!is_near(value, d * cosine / (4 * dot(wo, half))), "density-of-directions",
                   gave(what, value, right));
  }
  REQUIRE(is_right(what, value, right));
}

TEST_CASE("where the facets face up, a direction may lie below the surface") {
  const vec3 wo{0.6f, 0, 0.8f}, low{0.8f, 0, -0.6f};  // half-way lies (7, 0, 1) / sqrt(50)
  const vec3 above{0, 0.8f, 0.6f};
  const bool is_above_right =
      is_near(ggx_d_between(0.3f, wo, above), expected(0.3f, normalize(wo + above)));
  for (const auto& [o, i] : {std::pair(wo, low), std::pair(low, wo)}) {
    const std::string what = call("ggx_d_between", 0.3f, o, i);
    const double value = ggx_d_between(0.3f, o, i), right = expected(0.3f, normalize(o + i));
    lt::diagnose(!is_above_right || value != 0, "side-asked", gave(what, value, right));
    REQUIRE(is_right(what, value, right));
  }
}

TEST_CASE("no facet mirrors light straight through") {
  const vec3 wo{0.6f, 0, 0.8f};
  const double opposite = ggx_d_between(0.3f, wo, -wo);
  lt::diagnose(!is_right_in_the_middle() || !std::isnan(opposite), "nan-for-opposite",
               gave(call("ggx_d_between", 0.3f, wo, -wo), opposite, 0));
  REQUIRE(is_right(call("ggx_d_between", 0.3f, wo, -wo), opposite, 0));
}

TEST_CASE("at random places, all three are right") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 200; ++i) {
      const auto alpha = static_cast<float>(random.uniform(0.1, 1));
      const vec2 alphas(alpha, random.uniform(0.1, 1));
      const vec3 wo = random.direction();
      const vec3 wi = random.direction();
      REQUIRE(d_is_right(alpha, wo));
      REQUIRE(brushed_is_right(alphas, wo, wo));
      const vec3 h = normalize(wo + wi);
      if (length(wo + wi) < 0.3f || std::abs(h.z) < 1e-3f) continue;  // few digits of h are left
      REQUIRE(is_right(call("ggx_d_between", alpha, wo, wi), ggx_d_between(alpha, wo, wi),
                       expected(alpha, h)));
    }
  }
}
