#include "api.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::brushed_ggx_d;
using exercise::ggx_d;
using exercise::ggx_d_between;
using glm::dvec2;
using glm::vec2;
using glm::vec3;
using lt::text_of;
using std::numbers::pi;

double square(double x) {
  return x * x;
}

// Walter and others 2007, eq. 33, in double, with the tangent along each axis measured by itself.
double expected(dvec2 alphas, vec3 h) {
  const glm::dvec3 n(h);
  if (n.z <= 0) return 0;
  const double squared = square(n.x / n.z / alphas.x) + square(n.y / n.z / alphas.y);
  return 1 / (pi * alphas.x * alphas.y * std::pow(n.z, 4) * square(1 + squared));
}
double expected(double alpha, vec3 h) {
  return expected(dvec2(alpha), h);
}

bool is_near(double value, double right, double relative = 1e-4) {
  return std::abs(value - right) <= relative * std::abs(right);  // false for NaN
}

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

using Formula = std::function<double(double alpha, vec3 h)>;
// Does ggx_d() give what this formula gives, everywhere?
bool is(const Formula& formula) {
  for (const float alpha : {0.1f, 0.3f, 0.5f})
    for (const vec3 h : normals)
      if (!is_near(ggx_d(alpha, h), formula(alpha, h))) return false;
  return true;
}

// Where this is false, a mistake has been named already and must not pass for another one.
bool is_right_in_the_middle() {
  return is(static_cast<double (*)(double, vec3)>(expected));
}

const std::array<std::pair<const char*, Formula>, 11> mistakes{{
    {"alpha-squared-twice", [](double a, vec3 h) { return expected(a * a, h); }},
    {"alpha-not-squared", [](double a, vec3 h) { return expected(std::sqrt(a), h); }},
    {"alpha-once-above", [](double a, vec3 h) { return expected(a, h) / a; }},
    {"pi-forgotten", [](double a, vec3 h) { return expected(a, h) * pi; }},
    {"cos4-forgotten", [](double a, vec3 h) { return expected(a, h) * std::pow(h.z, 4); }},
    {"cos2-for-cos4", [](double a, vec3 h) { return expected(a, h) * h.z * h.z; }},
    {"cosine-included", [](double a, vec3 h) { return expected(a, h) * h.z; }},
    {"tan-not-squared",
     [](double a, vec3 h) {
       const double tan = std::sqrt(1.0 - h.z * h.z) / h.z;
       return a * a / (pi * std::pow(h.z, 4) * square(a * a + tan));
     }},
    {"sine-for-tangent",
     [](double a, vec3 h) {
       return a * a / (pi * std::pow(h.z, 4) * square(a * a + 1.0 - h.z * h.z));
     }},
    {"bracket-not-squared",
     [](double a, vec3 h) {
       return expected(a, h) * (a * a + (h.x * h.x + h.y * h.y) / (h.z * h.z));
     }},
    {"normal-along-y", [](double a, vec3 h) { return expected(a, vec3(h.x, h.z, h.y)); }},
}};

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
  // A width of 1e-4 and a facet that leans by as much: the z of its normal is 1 in float.
  const vec3 leaning{0.6e-4f, 0.8e-4f, 1};
  lt::diagnose(
      !is_right_in_the_middle() || is_near(ggx_d(1e-4f, leaning), expected(1e-4f, leaning), 0.01),
      "digits-cancelled", d_gave(1e-4f, leaning));
  REQUIRE(d_is_right(1e-4f, {0, 0, 1}));
  for (const vec3 h : {vec3(0.6f, 0.8f, 0), vec3(0, 1, 1e-12f), vec3(0, 1, 1e-30f)})
    lt::diagnose(!is_right_in_the_middle() || is_near(ggx_d(0.5f, h), expected(0.5f, h)) ||
                     (h.z == 0 && !std::isnan(ggx_d(0.5f, h))),
                 "lost-at-the-horizon", d_gave(0.5f, h));
  REQUIRE(d_is_right(0.5f, {0.6f, 0.8f, 0}));
}

TEST_CASE("the facets, seen from straight above, cover the surface once") {
  for (const float alpha : {1.0f, 0.3f, 0.05f}) {
    const auto seen_area = [&](vec3 h) { return ggx_d(alpha, h) * h.z; };
    INFO("Times the cosine, for alpha " << alpha << ", in sum and up to the angle atan(alpha):");
    REQUIRE(is_right("ggx_d", sum(seen_area), 1, 1e-3));
    REQUIRE(is_right("ggx_d", sum(seen_area, std::atan(alpha)), 0.5, 1e-3));
  }
  const double half = sum([](vec3 h) { return ggx_d(0.3f, h) * h.z; }, std::atan(0.3));
  lt::measured(text_of(100 * half) +
               " % of a surface lean by less than the angle whose tangent is "
               "alpha: for alpha 0.3 that is 16.7 degrees");
}

TEST_CASE("brushed_ggx_d has a width for each axis") {
  using Brushed = std::function<double(dvec2 a, vec3 h)>;
  const std::array<std::pair<const char*, Brushed>, 5> brushed_mistakes{{
      {"one-alpha-in-front", [](dvec2 a, vec3 h) { return expected(a, h) * a.y / a.x; }},
      {"axes-swapped", [](dvec2 a, vec3 h) { return expected(dvec2(a.y, a.x), h); }},
      {"widths-not-squared",
       [](dvec2 a, vec3 h) { return expected(glm::sqrt(a), h) / std::sqrt(a.x * a.y); }},
      {"one-mean-width", [](dvec2 a, vec3 h) { return expected(std::sqrt(a.x * a.y), h); }},
      {"one-mean-width", [](dvec2 a, vec3 h) { return expected((a.x + a.y) / 2, h); }},
  }};
  const vec2 alphas{0.2f, 0.5f};
  const std::string seen = gave(call("brushed_ggx_d", alphas, first), brushed_ggx_d(alphas, first),
                                expected(dvec2(alphas), first));
  for (const auto& [tag, formula] : brushed_mistakes) {
    std::size_t fits = 0;
    for (const vec3 h : normals)
      fits += is_near(brushed_ggx_d(alphas, h), formula(alphas, h));
    lt::diagnose(fits < normals.size(), tag, seen);
  }
  for (const vec3 h : normals) {
    REQUIRE(is_right(call("brushed_ggx_d", alphas, h), brushed_ggx_d(alphas, h),
                     expected(dvec2(alphas), h)));
    for (const vec3 turned : {vec3(-h.x, h.y, h.z), vec3(h.x, -h.y, h.z)})
      REQUIRE(is_right(call("brushed_ggx_d", alphas, turned), brushed_ggx_d(alphas, turned),
                       expected(dvec2(alphas), h)));
  }
  const vec3 below{0.6f, 0, -0.8f};
  lt::diagnose(brushed_ggx_d(alphas, below) == 0, "faces-down",
               gave(call("brushed_ggx_d", alphas, below), brushed_ggx_d(alphas, below), 0));
  const double whole = sum([](vec3 h) { return brushed_ggx_d({0.1f, 0.5f}, h) * h.z; });
  REQUIRE(is_right("The sum of brushed_ggx_d times the cosine for (0.1, 0.5)", whole, 1, 1e-3));
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
  if (!is_near(value, ggx_d(0.3f, normalize(wo + wi))))
    for (const auto& [tag, h] : wrong_normals)
      lt::diagnose(!is_near(value, ggx_d(0.3f, h)), tag, gave(what, value, right));
  REQUIRE(is_right(what, value, right));
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
      REQUIRE(is_right(call("brushed_ggx_d", alphas, wo), brushed_ggx_d(alphas, wo),
                       expected(dvec2(alphas), wo)));
      const vec3 h = normalize(wo + wi);
      if (length(wo + wi) < 0.3f || std::abs(h.z) < 1e-3f) continue;  // few digits of h are left
      REQUIRE(is_right(call("ggx_d_between", alpha, wo, wi), ggx_d_between(alpha, wo, wi),
                       expected(alpha, h)));
    }
  }
}
