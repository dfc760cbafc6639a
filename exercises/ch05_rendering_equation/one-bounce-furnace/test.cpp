#include "api.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::DirectionSample;
using exercise::lambert;
using exercise::reflected;
using exercise::Sampler;
using glm::dvec2;
using glm::dvec3;

const double pi = std::acos(-1.0);

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6;  // float arithmetic passes, NaN does not
}

std::string gave(const std::string& call, double value, double expected) {
  std::ostringstream text;
  text << call << " gave " << value << " and should give " << expected << '.';
  return text.str();
}

bool is_right(const std::string& call, double value, double expected, double tolerance = 1e-6) {
  const bool is_so = std::abs(value - expected) < tolerance;
  if (!is_so) UNSCOPED_INFO(gave(call, value, expected));
  return is_so;
}

// To the viewer, and where light comes from: unit vectors with few digits.
const dvec3 wo{0, 0.8, 0.6}, high{0.6, 0, 0.8}, flat{-0.96, 0, 0.28}, below{0.6, 0, -0.8};

// A sky that is brighter in the east (x) and in the north (y).
double slanted_sky(dvec3 w) {
  return 2 + w.x + 2 * w.y;
}

// Asks one direction for each u: 0.2 is `high`, 0.4 is `flat`, 0.6 is `below`.
DirectionSample scripted(dvec2 u) {
  if (u.x < 0.3) return {high, 0.25};
  if (u.x < 0.5) return {flat, 0.125};
  return {below, 0.5};
}

double asked(const std::vector<double>& which) {
  std::vector<dvec2> us;
  for (const double u : which)
    us.emplace_back(u, 0.5);
  return reflected(0.5, wo, scripted, slanted_sky, us);
}

// Three ways to choose directions.
DirectionSample uniform(dvec2 u) {
  const double radius = std::sqrt(u.x * (2 - u.x));
  return {{radius * std::cos(2 * pi * u.y), radius * std::sin(2 * pi * u.y), 1 - u.x},
          1 / (2 * pi)};
}
DirectionSample cosine(dvec2 u) {
  const double radius = std::sqrt(u.x);
  const double z = std::sqrt(1 - u.x);
  return {{radius * std::cos(2 * pi * u.y), radius * std::sin(2 * pi * u.y), z}, z / pi};
}
DirectionSample whole_sphere(dvec2 u) {
  const double z = 1 - 2 * u.x;
  const double radius = 2 * std::sqrt(u.x * (1 - u.x));
  return {{radius * std::cos(2 * pi * u.y), radius * std::sin(2 * pi * u.y), z}, 1 / (4 * pi)};
}
const std::array<std::pair<std::string, Sampler>, 3> ways{{
    {"the uniform sampler", uniform},
    {"the cosine sampler", cosine},
    {"a sampler of the whole sphere", whole_sphere},
}};

// A random place in each cell of a grid of 100 x 100. f cos / pdf is at most 4 z (whole sphere),
// and z runs from 1 to -1: over one cell it changes by 0.08 and has a standard deviation of 0.08 /
// sqrt(12), the mean of 10,000 cells 2.3e-4. A right answer is 20 of them away from 1 % of 1/2.
std::vector<dvec2> numbers(std::uint64_t seed) {
  lt::TestRandom random(seed);
  std::vector<dvec2> us;
  for (int i = 0; i < 10'000; ++i) {
    const double x = random.uniform();
    const double y = random.uniform();
    us.emplace_back((i % 100 + x) / 100, (i / 100 + y) / 100);
  }
  return us;
}

}  // namespace

TEST_CASE("Lambert's surface is as bright from every side, and dark from behind") {
  const double value = lambert(0.5, wo, high);
  const std::string call = "lambert(0.5, wo, wi) with wi = (0.6, 0, 0.8)";
  const std::string seen = gave(call, value, 0.5 / pi);
  lt::diagnose(!is_near(value, 0.5), "pi-forgotten", seen);
  lt::diagnose(!is_near(value, 0.5 / (2 * pi)), "area-for-cosine", seen);
  lt::diagnose(!is_near(value, 0.5 / pi * high.z), "cosine-in-lambert", seen);
  REQUIRE(is_right(call, value, 0.5 / pi));
  const double behind = lambert(0.5, wo, below);
  const std::string call_behind = "lambert(0.5, wo, wi) with wi = (0.6, 0, -0.8)";
  lt::diagnose(!is_near(behind, 0.5 / pi), "light-from-below", gave(call_behind, behind, 0));
  REQUIRE(is_right(call_behind, behind, 0));
  REQUIRE(is_right("lambert(0.9, wo, wi), both above,", lambert(0.9, wo, flat), 0.9 / pi));
  REQUIRE(is_right("lambert(0.9, wo, wi), changed over,", lambert(0.9, flat, wo), 0.9 / pi));
  REQUIRE(is_right("lambert(0.9, wo, wi), both below,", lambert(0.9, -wo, below), 0.9 / pi));
  REQUIRE(is_right("lambert(0.9, wo, wi), only wo below,", lambert(0.9, -wo, high), 0));
}

TEST_CASE("one direction brings BRDF times sky times cosine, over the density") {
  const double value = asked({0.2});
  const double f = 0.5 / pi;
  const double light = 2.6;  // from (0.6, 0, 0.8); towards wo, (0, 0.8, 0.6), the sky is 3.6
  const double right = f * light * 0.8 / 0.25;
  const std::string call =
      "One direction with cosine 0.8, density 0.25 and light 2.6, at albedo 0.5,";
  const std::array<std::pair<const char*, double>, 8> mistakes{{
      {"cosine-forgotten", f * light / 0.25},
      {"cosine-of-wo", f * light * 0.6 / 0.25},
      {"pi-forgotten", 0.5 * light * 0.8 / 0.25},
      {"pdf-forgotten", f * light * 0.8},
      {"pdf-multiplied", f * light * 0.8 * 0.25},
      {"uniform-assumed", f * light * 0.8 * 2 * pi},
      {"cosine-assumed", 0.5 * light},
      {"sky-at-wo", f * 3.6 * 0.8 / 0.25},
  }};
  // A wrong lambert() has been named already and must not pass for another mistake.
  if (is_near(lambert(0.5, wo, high), f))
    for (const auto& [tag, wrong] : mistakes)
      lt::diagnose(!is_near(value, wrong), tag, gave(call, value, right));
  REQUIRE(is_right(call, value, right));
}

TEST_CASE("several directions: the mean over all that were asked") {
  const double one = asked({0.2});
  const double other = asked({0.4});
  REQUIRE(is_right("One direction with cosine 0.28, density 0.125 and light 1.04, at albedo 0.5,",
                   other, 0.5 / pi * 1.04 * 0.28 / 0.125));
  const double both = asked({0.2, 0.4});
  std::ostringstream call;
  call << "Two directions that bring " << one << " and " << other << " when asked alone";
  lt::diagnose(!is_near(both, one + other), "sum-not-mean",
               gave(call.str(), both, (one + other) / 2));
  REQUIRE(is_right(call.str(), both, (one + other) / 2));
  // The second, below the horizon, would bring f * 2.6 * 0.8 / 0.5, half as much as the first.
  const double with_dark = asked({0.2, 0.6});
  std::ostringstream call_dark;
  call_dark << "A direction that brings " << one << " and one below the horizon";
  const std::string seen = gave(call_dark.str(), with_dark, one / 2);
  for (const double through : {0.5, -0.5})
    lt::diagnose(!is_near(with_dark, (one + through * one) / 2), "light-from-below", seen);
  lt::diagnose(!is_near(with_dark, one), "divided-by-lit", seen);
  REQUIRE(is_right(call_dark.str(), with_dark, one / 2));
}

TEST_CASE("in a furnace the surface sends back its albedo, whatever the sampler") {
  const auto even_sky = [](dvec3) { return 1.0; };
  const auto bright_zenith = [](dvec3 w) { return std::abs(w.z); };
  std::ostringstream report;
  for (const auto seed : lt::seeds()) {
    const std::vector<dvec2> us = numbers(seed);
    for (const auto& [name, sampler] : ways) {
      const double mean = reflected(0.5, wo, sampler, even_sky, us);
      REQUIRE(is_right("Albedo 0.5 under a sky of 1, with " + name + ',', mean, 0.5, 0.005));
      // The mean of z where directions follow the cosine is 2/3.
      const double zenith = reflected(0.5, wo, sampler, bright_zenith, us);
      REQUIRE(is_right("Albedo 0.5 under a sky of z, with " + name + ',', zenith, 1 / 3.0, 0.003));
      if (seed == 1) report << mean << " with " << name << ", ";
    }
  }
  lt::measured("albedo 0.5 under a sky of 1: " + report.str() + "from 10,000 directions each");
}
