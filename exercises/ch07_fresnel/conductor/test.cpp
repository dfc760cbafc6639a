#include "api.hpp"
#include "formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"

namespace {

using namespace oracle;
using exercise::fresnel_conductor;
using exercise::Rgb;
using lt::text_of;

double given(Place at) {
  return fresnel_conductor(at.c, at.n_here, at.eta, at.k);
}

std::vector<Place> make_places() {
  std::vector<Place> all;
  // A sheer mirror; then like iron, copper (green) and gold (blue).
  for (const auto& [eta, k] : {std::pair(0.271, 3.609), {2.9, 3.1}, {1.02, 2.577}, {1.31, 1.849}})
    for (const double n_here : {1.0, 1.33})
      for (const double c : {1.0, 0.8, 0.5, 0.1})
        all.push_back({c, n_here, eta, k});
  return all;
}
const std::vector<Place> places = make_places();

Place first_wrong() {
  const auto is_wrong = [](Place at) { return !is_near(given(at), exact(at)); };
  const auto found = std::find_if(places.begin(), places.end(), is_wrong);
  return found == places.end() ? places[0] : *found;
}
bool is_right_everywhere() {
  return is_near(given(first_wrong()), exact(first_wrong()));
}

std::string gave(Place at, double expected) {
  return "At the cosine " + (at.c > 1 ? "1 + 1e-9" : text_of(at.c)) + ", from index " +
         text_of(at.n_here) + " to eta " + text_of(at.eta) + " and k " + text_of(at.k) +
         ", the share gave " + text_of(given(at)) + " and should give " + text_of(expected) + ".";
}
bool is_right(Place at, double expected) {
  const bool is_so = is_near(given(at), expected);
  if (!is_so) UNSCOPED_INFO(gave(at, expected));
  return is_so;
}

bool made_by(Wrong mistake) {
  return std::all_of(places.begin(), places.end(), [&](Place at) {
    const double sin2 = 1 - squared(at.c);
    const double wrong =
        mistake(at, {amplitudes(at, sin2), sin2, quotient(at) * quotient(at) - sin2});
    // Where a real root would be negative, complex arithmetic says 1 and real arithmetic NaN.
    const bool may_be_nan = is_near(wrong, 1) && at.c < 1;
    return is_near(given(at), wrong) || (may_be_nan && std::isnan(given(at)));
  });
}

}  // namespace

TEST_CASE("metals, from air and from water") {
  if (const std::string seen = gave(first_wrong(), exact(first_wrong())); !is_right_everywhere()) {
    for (const auto& [tag, mistake] : mistakes)
      lt::diagnose(!made_by(mistake), tag, seen);
    lt::diagnose(!std::isnan(given(first_wrong())), "metal-nan", seen);
  }
  // Straight on: ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2) = 13.556322 / 14.640322.
  REQUIRE(is_right(places[0], 13.556322 / 14.640322));
  for (const Place at : places)
    REQUIRE(is_right(at, exact(at)));
  for (const Place at : places)  // along the surface everything is reflected
    REQUIRE(is_right({0, at.n_here, at.eta, at.k}, 1));
}

TEST_CASE("without k it is glass, total reflection included") {
  // sin 0.6 here, 0.6 / 1.5 = 0.4 beyond; the way back reflects as much.
  const double t = std::sqrt(0.84);
  const double s = (0.8 - 1.5 * t) / (0.8 + 1.5 * t);
  const double p = (1.5 * 0.8 - t) / (1.5 * 0.8 + t);
  REQUIRE(is_right({1, 1, 1.5, 0}, 0.04));  // (0.5 / 2.5)^2
  REQUIRE(is_right({0.8, 1, 1.5, 0}, (s * s + p * p) / 2));
  REQUIRE(is_right({t, 1.5, 1, 0}, (s * s + p * p) / 2));
  const Place total{0.5, 1.5, 1, 0};
  if (is_right_everywhere())
    lt::diagnose(!std::isnan(given(total)), "no-total-reflection", gave(total, 1));
  REQUIRE(is_right(total, 1));
  for (const double c : {1.0, 0.5, 0.0}) {
    const Place none{c, 1.5, 1.5, 0};
    if (is_right_everywhere())
      lt::diagnose(!std::isnan(given(none)) && !is_near(given(none), 1), "equal-indices",
                   gave(none, 0));
    REQUIRE(is_right(none, 0));
  }
}

TEST_CASE("a cosine that rounding left above 1") {
  const Place above{1 + 1e-9, 1, 0.271, 3.609};
  if (is_right_everywhere())
    lt::diagnose(!std::isnan(given(above)), "cosine-above-one", gave(above, exact(places[0])));
  REQUIRE(is_right(above, exact(places[0])));
}

TEST_CASE("a metal in colour: each channel has its own eta and its own k") {
  const Rgb eta(0.3, 1.02, 1.25), k(3.205, 2.577, 2.483);
  const std::array<std::string, 3> names{"red", "green", "blue"};
  const Rgb value = fresnel_conductor(0.7, 1.33, eta, k);
  for (int c = 0; c < 3; ++c) {
    const double expected = exact({0.7, 1.33, eta[c], k[c]});
    const std::string seen = "At the cosine 0.7, from index 1.33 to eta " + text_of(eta[c]) +
                             " and k " + text_of(k[c]) + ", the " + names[c] + " channel gave " +
                             text_of(value[c]) + " and should give " + text_of(expected) + ".";
    const bool is_wrong = is_right_everywhere() && !is_near(value[c], expected);
    for (int i = 0; i < 9 && is_wrong; ++i)
      lt::diagnose(!is_near(value[c], exact({0.7, 1.33, eta[i / 3], k[i % 3]})), "channels-mixed",
                   seen + " That is eta of " + names[i / 3] + " with k of " + names[i % 3] + ".");
    INFO(seen);
    REQUIRE(is_near(value[c], expected));
  }
}

TEST_CASE("any metal: as complex arithmetic has it") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 200; ++i) {
      const Place at{random.uniform(), random.uniform(1, 1.6), random.uniform(0.05, 4),
                     random.uniform(0.001, 7)};
      REQUIRE(is_right(at, exact(at)));
    }
  }
  const Rgb gold = fresnel_conductor(1, 1, Rgb(0.21, 0.43, 1.31), Rgb(3.272, 2.455, 1.849));
  std::ostringstream text;
  text.precision(3);
  text << "gold reflects " << gold.r << " of red light straight on, " << gold.g << " of green and "
       << gold.b << " of blue";
  lt::measured(text.str());
}
