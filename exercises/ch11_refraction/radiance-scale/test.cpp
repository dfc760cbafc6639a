#include "api.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::Choice;
using exercise::choose;
using exercise::crossing_scale;
using exercise::light_at_camera;
using exercise::Transport;
using lt::text_of;
using lt::text_of_u;

constexpr Transport radiance = Transport::radiance, importance = Transport::importance;
const double almost_one = 1.0 - 0x1p-53;

double square(double x) {
  return x * x;
}

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6 * std::max(1.0, std::abs(b));  // float passes, NaN does not
}

std::string shown(Transport transport) {
  return transport == radiance ? "radiance" : "importance";
}
std::string gave(const std::string& what, double value, double expected) {
  return what + " gave " + text_of(value) + " and should give " + text_of(expected) + '.';
}
bool is_right(const std::string& what, double value, double expected) {
  if (!is_near(value, expected)) UNSCOPED_INFO(gave(what, value, expected));
  return is_near(value, expected);
}

// The solid angle of a narrow bundle about the normal, here over beyond: sines are as Snell says.
double right_scale(double here, double beyond, Transport transport) {
  return transport == radiance ? square(here) / square(beyond) : 1;
}

// Air, water, glass, diamond.
const std::array<std::pair<double, double>, 5> crossings{
    {{1, 1.5}, {1.5, 1}, {1.33, 1.5}, {1.5, 1.33}, {1, 2.4}}};
std::string call(double here, double beyond, Transport transport) {
  return "crossing_scale(" + text_of(here) + ", " + text_of(beyond) + ", " + shown(transport) + ')';
}
std::string gave(double here, double beyond, Transport transport) {
  return gave(call(here, beyond, transport), crossing_scale(here, beyond, transport),
              right_scale(here, beyond, transport));
}

using Scale = std::function<double(double here, double beyond)>;
bool scale_is(Transport transport, const Scale& formula) {
  return std::all_of(crossings.begin(), crossings.end(), [&](const auto& crossing) {
    const auto& [here, beyond] = crossing;
    return is_near(crossing_scale(here, beyond, transport), formula(here, beyond));
  });
}
double one(double, double) {
  return 1;
}
double squared_eta(double here, double beyond) {
  return square(here / beyond);
}
double inverted(double here, double beyond) {
  return square(beyond / here);
}
// Where this is false, a mistake has been named already and must not pass for another one.
bool scale_is_right() {
  return scale_is(radiance, squared_eta) && scale_is(importance, one);
}

const std::array<std::pair<const char*, Scale>, 5> radiance_mistakes{{
    {"no-scale", one},
    {"one-over-eta", [](double here, double beyond) { return here / beyond; }},
    {"scale-inverted", inverted},
    {"entering-only",
     [](double here, double beyond) { return here < beyond ? square(here / beyond) : 1; }},
    {"fresnel-for-scale",
     [](double here, double beyond) { return 4 * here * beyond / square(here + beyond); }},
}};

// Choices, with u far below and far above the share.
struct Case {
  double share, u, here, beyond;
  Transport transport;
};
const std::array<Case, 6> cases{{{0.25, 0.125, 1, 1.5, radiance},
                                 {0.25, 0.75, 1, 1.5, radiance},
                                 {0.625, 0.5, 1.5, 1, radiance},
                                 {0.625, 0.875, 1.5, 1, radiance},
                                 {0.25, 0.125, 1, 1.5, importance},
                                 {0.25, 0.75, 1, 1.5, importance}}};
Choice answer(const Case& c) {
  return choose(c.share, c.u, c.here, c.beyond, c.transport);
}
Choice right_choice(const Case& c) {
  if (c.u < c.share) return {false, 1};
  return {true, right_scale(c.here, c.beyond, c.transport)};
}
std::string shown(const Choice& choice) {
  return (choice.goes_through ? "a path through, of weight " : "a reflected path of weight ") +
         text_of(choice.weight);
}
std::string gave(const Case& c) {
  return "choose(" + text_of(c.share) + ", " + text_of_u(c.u) + ", " + text_of(c.here) + ", " +
         text_of(c.beyond) + ", " + shown(c.transport) + ") gave " + shown(answer(c)) +
         " and should give " + shown(right_choice(c)) + '.';
}
bool is_right(const Case& c) {
  const Choice is = answer(c), should = right_choice(c);
  const bool is_so = is.goes_through == should.goes_through && is_near(is.weight, should.weight);
  if (!is_so) UNSCOPED_INFO(gave(c));
  return is_so;
}

// The weight that a mistake gives, if the way is right.
using Weight = std::function<double(const Case& c)>;
double right_weight(const Case& c) {
  return right_choice(c).weight;
}
const std::array<std::pair<const char*, Weight>, 5> weight_mistakes{{
    {"share-kept",
     [](const Case& c) { return right_weight(c) * (c.u < c.share ? c.share : 1 - c.share); }},
    {"share-forgotten",
     [](const Case& c) { return right_weight(c) / (c.u < c.share ? c.share : 1 - c.share); }},
    {"reflection-scaled", [](const Case& c) { return right_scale(c.here, c.beyond, c.transport); }},
    {"through-unscaled", [](const Case&) { return 1; }},
    {"transport-ignored",
     [](const Case& c) { return c.u < c.share ? 1 : right_scale(c.here, c.beyond, radiance); }},
}};

// Paths from the camera to the light, and what of a light of 8 is left by a right or wrong rule.
using Path = std::vector<double>;
const std::array<Path, 5> paths{
    {{1, 1.5}, {1.33, 1.5, 1}, {1.33, 1.5, 2.4}, {1.5, 1, 1.33, 2.4}, {1, 1.5, 1}}};
using Left = std::function<double(const Path& path)>;
double right_left(const Path& path) {
  return 8 * square(path.front() / path.back());
}
const std::array<std::pair<const char*, Left>, 5> path_mistakes{{
    {"path-inverted", [](const Path& p) { return 8 * square(p.back() / p.front()); }},
    {"first-crossing-only", [](const Path& p) { return 8 * square(p[0] / p[1]); }},
    {"last-crossing-only", [](const Path& p) { return 8 * square(*(p.end() - 2) / p.back()); }},
    {"last-crossing-missed", [](const Path& p) { return 8 * square(p[0] / *(p.end() - 2)); }},
    {"camera-in-air", [](const Path& p) { return 8 / square(p.back()); }},
}};
std::string gave(const Path& path) {
  std::string media;
  for (const double index : path)
    media += (media.empty() ? "" : ", ") + text_of(index);
  return gave("light_at_camera(8, {" + media + "})", light_at_camera(8, path), right_left(path));
}

// Names a mistake that agrees with the answer everywhere, and shows a place where it is one.
template <class Item, std::size_t n, class Is, class IsRight>
void diagnose_all(const char* tag, const std::array<Item, n>& items, Is is, IsRight is_right) {
  if (!std::all_of(items.begin(), items.end(), is)) return;
  const auto example = std::find_if_not(items.begin(), items.end(), is_right);
  if (example != items.end()) lt::diagnose(false, tag, gave(*example));
}

}  // namespace

TEST_CASE("crossing a surface: radiance changes with the square of the index, energy does not") {
  lt::diagnose(!scale_is(radiance, one) || !scale_is(importance, squared_eta), "transports-swapped",
               gave(1, 1.5, radiance) + ' ' + gave(1, 1.5, importance));
  for (const auto& [tag, formula] : radiance_mistakes)
    lt::diagnose(!scale_is(radiance, formula), tag,
                 is_near(crossing_scale(1, 1.5, radiance), 1 / 2.25) ? gave(1.5, 1, radiance)
                                                                     : gave(1, 1.5, radiance));
  const bool is_right_so_far = scale_is(radiance, squared_eta);
  lt::diagnose(!is_right_so_far || !scale_is(importance, squared_eta), "importance-scaled",
               gave(1, 1.5, importance));
  lt::diagnose(!is_right_so_far || !scale_is(importance, inverted), "importance-inverted",
               gave(1, 1.5, importance));
  for (const auto& [here, beyond] : crossings)
    for (const Transport transport : {radiance, importance})
      REQUIRE(is_right(call(here, beyond, transport), crossing_scale(here, beyond, transport),
                       right_scale(here, beyond, transport)));
  lt::measured("radiance that comes out of glass of index 1.5 is " +
               text_of(crossing_scale(1, 1.5, radiance)) + " of what it was, and into glass " +
               text_of(crossing_scale(1.5, 1, radiance)) + " times as much");
}

TEST_CASE("each way as often as it has light, and nothing left to weigh but the scale") {
  const auto is_swapped = [](const Case& c) { return answer(c).goes_through == (c.u < c.share); };
  lt::diagnose(!std::all_of(cases.begin(), cases.end(), is_swapped), "shares-swapped",
               gave(cases[0]));
  // A wrong crossing_scale() has been named already.
  if (scale_is_right())
    for (const auto& [tag, weight] : weight_mistakes)
      diagnose_all(
          tag, cases,
          [w = weight](const Case& c) {
            return answer(c).goes_through == right_choice(c).goes_through &&
                   is_near(answer(c).weight, w(c));
          },
          [](const Case& c) { return is_near(answer(c).weight, right_weight(c)); });
  for (const Case& c : cases)
    REQUIRE(is_right(c));
  const Case nothing_reflected{0, 0, 1, 1.5, radiance};
  lt::diagnose(answer(nothing_reflected).goes_through, "edge-included", gave(nothing_reflected));
  for (const Case& c : {nothing_reflected, Case{0, almost_one, 1, 1.5, radiance},
                        Case{1, 0, 1.5, 1, radiance}, Case{1, almost_one, 1.5, 1, radiance}})
    REQUIRE(is_right(c));
}

TEST_CASE("along a path each crossing counts") {
  if (scale_is_right())
    for (const auto& [tag, left] : path_mistakes)
      diagnose_all(
          tag, paths, [f = left](const Path& p) { return is_near(light_at_camera(8, p), f(p)); },
          [](const Path& p) { return is_near(light_at_camera(8, p), right_left(p)); });
  for (const Path& path : paths) {
    INFO(gave(path));
    REQUIRE(is_near(light_at_camera(8, path), right_left(path)));
  }
  REQUIRE(is_right("A light of 8 seen in its own medium of index 1.5",
                   light_at_camera(8, Path{1.5}), 8));
}

TEST_CASE("at random places") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 200; ++i) {
      const Transport transport = random.next_bits() % 2 == 0 ? radiance : importance;
      REQUIRE(is_right(Case{random.uniform(), random.uniform(), random.uniform(0.5, 3),
                            random.uniform(0.5, 3), transport}));
      Path path(1 + random.next_bits() % 6);
      for (double& index : path)
        index = random.uniform(0.5, 3);
      INFO(gave(path));
      REQUIRE(is_near(light_at_camera(8, path), right_left(path)));
    }
  }
}
