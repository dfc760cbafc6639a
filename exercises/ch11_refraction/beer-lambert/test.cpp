#include "api.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::pane_transmittance;
using exercise::path_transmittance;
using exercise::Rgb;
using exercise::transmittance;
using exercise::Vertex;
using glm::dvec3;
using lt::text_of;
using std::numbers::pi;

// Channel by channel, by the definition.
Rgb right(Rgb attenuation, double distance) {
  Rgb left;
  for (int i = 0; i < 3; ++i)
    left[i] = std::exp(-attenuation[i] * distance);
  return left;
}

bool is_near(Rgb a, Rgb b) {
  return distance(a, b) < 1e-6;  // float arithmetic passes, NaN does not
}

std::string gave(const std::string& what, Rgb value, Rgb expected) {
  return what + " gave " + text_of(value) + " and should give " + text_of(expected) + '.';
}
bool is_right(const std::string& what, Rgb value, Rgb expected) {
  if (!is_near(value, expected)) UNSCOPED_INFO(gave(what, value, expected));
  return is_near(value, expected);
}

const Rgb green(2.0, 0.5, 1.25), brown(0.25, 0.75, 1.5);

using Way = std::function<Rgb(double distance)>;
// Is transmittance(green, ...) this function, for several distances?
bool way_is(const Way& formula) {
  for (const double distance : {0.3, 0.8, 1.5})
    if (!is_near(transmittance(green, distance), formula(distance))) return false;
  return true;
}
// Where this is false, a mistake has been named already and must not pass for another one.
bool way_is_right() {
  return way_is([](double d) { return right(green, d); });
}
const std::array<std::pair<const char*, Way>, 8> way_mistakes{{
    {"brighter-inside", [](double d) { return right(-green, d); }},
    {"straight-line", [](double d) { return 1.0 - green * d; }},
    {"straight-line", [](double d) { return glm::max(Rgb(0.0), 1.0 - green * d); }},
    {"hyperbola", [](double d) { return 1.0 / (1.0 + green * d); }},
    {"attenuation-as-share", [](double d) { return glm::pow(green, Rgb(d)); }},
    {"base-ten", [](double d) { return right(green * std::log(10.0), d); }},
    {"grey", [](double d) { return right(Rgb((green.r + green.g + green.b) / 3.0), d); }},
    {"grey", [](double d) { return right(Rgb(green.r), d); }},
}};

// The way through a pane that is 0.4 m thick, from air, for an angle outside.
const double thickness = 0.4;
using Length = std::function<double(double theta, double index)>;
double right_length(double theta, double n) {
  return thickness / std::cos(std::asin(std::sin(theta) / n));
}
const std::array<std::pair<const char*, Length>, 6> pane_mistakes{{
    {"pane-straight-through", [](double, double) { return thickness; }},
    {"pane-angle-outside", [](double theta, double) { return thickness / std::cos(theta); }},
    {"pane-cosine-multiplied",
     [](double theta, double n) { return thickness * thickness / right_length(theta, n); }},
    {"pane-sine-for-cosine",
     [](double theta, double n) { return thickness * n / std::sin(theta); }},
    {"pane-indices-swapped",
     [](double theta, double n) { return right_length(theta, 1 / n); }},  // NaN beyond an angle
    {"pane-cosines-for-sines",
     [](double theta, double n) { return thickness / (std::cos(theta) / n); }},
}};

Rgb pane(double theta, double index) {
  return pane_transmittance(green, thickness, std::cos(theta), 1, index);
}
std::string pane_call(double theta, double index) {
  return "A pane 0.4 m thick, of attenuation " + text_of(green) + " and index " + text_of(index) +
         ", in air, at " + text_of(theta * 180 / pi) + " degrees,";
}
bool pane_is(const Length& length) {
  for (const double degrees : {20.0, 45.0, 65.0})
    for (const double index : {1.33, 1.5}) {
      const Rgb value = pane(degrees * pi / 180, index);
      const Rgb wrong = right(green, length(degrees * pi / 180, index));
      if (!is_near(value, wrong) && !(std::isnan(value.g) && std::isnan(wrong.g))) return false;
    }
  return true;
}

using Path = std::vector<Vertex>;
// Along z: air, a block of green glass from 0 to 0.3, where light is reflected once inside, air, a
// brown ball from 1 to 1.4, air, a wall. The wall has an attenuation, but nobody looks into it.
const Path simple{{{0, 0, 0}, true, green},
                  {{0, 0, 0.3}, false, green},
                  {{0, 0, 1}, true, brown},
                  {{0, 0, 1.4}, false, brown},
                  {{0, 0, 2}, true, Rgb(0.1, 0.2, 0.3)}};
const Path reflected{
    simple[0], simple[1], {{0, 0, 0.1}, false, green}, {{0, 0, 0.35}, false, green}, simple[2],
    simple[3], simple[4]};

// How long segment i of a path is, by a right or wrong rule; 0 if it does not count.
using Segments = std::function<double(const Path& path, std::size_t i)>;
const dvec3 camera{0, 0, -0.8};
double step(const Path& path, std::size_t i) {
  return distance(i == 0 ? camera : path[i - 1].position, path[i].position);
}
double right_step(const Path& path, std::size_t i) {
  return path[i].outside ? 0 : step(path, i);
}
double step_from_inside(const Path& path, std::size_t i) {
  dvec3 from = camera;
  for (std::size_t k = 0; k < i; ++k)
    if (!path[k].outside) from = path[k].position;
  return path[i].outside ? 0 : distance(from, path[i].position);
}
double last_step(const Path& path, std::size_t i) {
  for (std::size_t k = i + 1; k < path.size(); ++k)
    if (!path[k].outside) return 0;
  return right_step(path, i);
}
const std::array<std::pair<const char*, Segments>, 6> path_mistakes{{
    {"distance-from-camera",
     [](const Path& path, std::size_t i) {
       return path[i].outside ? 0 : distance(camera, path[i].position);
     }},
    {"absorb-outside",
     [](const Path& path, std::size_t i) { return step(path, i) - right_step(path, i); }},
    {"absorb-everywhere", step},
    {"start-not-moved", step_from_inside},
    {"last-segment-only", last_step},
    {"length-squared",
     [](const Path& path, std::size_t i) { return step(path, i) * right_step(path, i); }},
}};
Rgb left_along(const Path& path, const Segments& length) {
  Rgb depth(0.0);
  for (std::size_t i = 0; i < path.size(); ++i)
    depth += path[i].attenuation * length(path, i);
  return right(depth, 1);
}

}  // namespace

TEST_CASE("what is left falls by the same share on each metre") {
  const std::string call = "transmittance(" + text_of(green) + ", ";
  for (const auto& [tag, formula] : way_mistakes)
    lt::diagnose(!way_is(formula), tag,
                 gave(call + "0.8)", transmittance(green, 0.8), right(green, 0.8)));
  for (const double way : {0.0, 0.3, 0.8, 1.5, 40.0})
    REQUIRE(is_right(call + text_of(way) + ')', transmittance(green, way), right(green, way)));
  REQUIRE(is_right("transmittance((0, 0, 0), 5)", transmittance(Rgb(0.0), 5), Rgb(1.0)));
}

TEST_CASE("a pane is crossed along the bent ray") {
  const double theta = pi / 4;
  const std::string seen =
      gave(pane_call(theta, 1.5), pane(theta, 1.5), right(green, right_length(theta, 1.5)));
  if (way_is_right())
    for (const auto& [tag, length] : pane_mistakes)
      lt::diagnose(!pane_is(length), tag, seen);
  for (const double degrees : {45.0, 0.0, 20.0, 65.0, 89.0})
    for (const double index : {1.0, 1.33, 1.5, 2.4}) {
      const double angle = degrees * pi / 180;
      REQUIRE(is_right(pane_call(angle, index), pane(angle, index),
                       right(green, right_length(angle, index))));
    }
  // In water only the ratio of both indices counts.
  REQUIRE(is_right("A pane of index 1.8 in water of index 1.2 at 45 degrees",
                   pane_transmittance(green, thickness, std::cos(theta), 1.2, 1.8),
                   right(green, right_length(theta, 1.5))));
}

TEST_CASE("along a path only the segments inside an object take light away") {
  const Rgb value = path_transmittance(camera, simple);
  const Rgb longer = path_transmittance(camera, reflected);
  const std::string what = "A path through 0.3 m of attenuation " + text_of(green) +
                           " and 0.4 m of " + text_of(brown) + ", with 2.1 m of air,";
  if (way_is_right())
    for (const auto& [tag, length] : path_mistakes)
      lt::diagnose(!is_near(value, left_along(simple, length)) ||
                       !is_near(longer, left_along(reflected, length)),
                   tag, gave(what, value, left_along(simple, right_step)));
  REQUIRE(is_right(what, value, left_along(simple, right_step)));
  REQUIRE(is_right("The same path with two reflections inside the first glass", longer,
                   left_along(reflected, right_step)));
  REQUIRE(is_right("The same path, seen by a camera 100 m farther back,",
                   path_transmittance({0, 0, -100}, simple), value));
  const Path inside{{{0, 0.6, 0}, false, brown}};
  REQUIRE(is_right("A camera in the glass, 1 m from its surface,",
                   path_transmittance(camera, inside), right(brown, 1)));
  REQUIRE(is_right("A path without vertices", path_transmittance(camera, {}), Rgb(1.0)));
}

TEST_CASE("at random places") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 200; ++i) {
      const double a = random.uniform(0, 2), b = random.uniform(0, 2);
      REQUIRE(is_right("A way of " + text_of(a) + " m and one of " + text_of(b) + " m",
                       transmittance(brown, a + b), right(brown, a) * right(brown, b)));
      Path path(1 + random.next_bits() % 6);
      for (Vertex& vertex : path) {
        vertex.position = random.direction();
        vertex.outside = random.next_bits() % 2 == 0;
        vertex.attenuation = glm::abs(random.direction());
      }
      REQUIRE(is_right("A random path of " + std::to_string(path.size()) + " segments",
                       path_transmittance(camera, path), left_along(path, right_step)));
    }
  }
}

TEST_CASE("a parallel beam through a glass ball") {
  // A ball of radius 1 and index 1: rays at the distance s from its axis have a chord of
  // 2 sqrt(1 - s^2), and s^2 is even over the disk. The integral of exp(-2 a sqrt(1 - s^2)) over
  // s^2 is (1 - (1 + 2 a) exp(-2 a)) / (2 a^2).
  constexpr int rays = 2000;
  Rgb sum(0.0);
  for (int i = 0; i < rays; ++i) {
    const double c = (i + 0.5) / rays;  // sqrt(1 - s^2), asked evenly; d(s^2) is 2 c dc
    const double s = std::sqrt(1 - c * c);
    const Path path{{{s, 0, -c}, true, green}, {{s, 0, c}, false, green}};
    sum += 2 * c / rays * path_transmittance({s, 0, -3}, path);
  }
  const Rgb mean = (1.0 - (1.0 + 2.0 * green) * glm::exp(-2.0 * green)) / (2.0 * green * green);
  REQUIRE(is_right("The mean over the beam", sum, mean));
  lt::measured("a ball of radius 1 m and attenuation " + text_of(green) + " lets " + text_of(sum) +
               " of a parallel beam through");
}
