#include "api.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::fresnel_conductor;
using exercise::Rgb;
using Complex = std::complex<double>;
using namespace std::complex_literals;
using lt::text_of;

double squared(double x) {
  return x * x;
}

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6;  // double arithmetic is much closer; NaN never is
}

struct Place {
  double c, n_here, eta, k;
};

double given(Place at) {
  return fresnel_conductor(at.c, at.n_here, at.eta, at.k);
}

struct Amplitudes {
  Complex s, p;
};
double mean_of_norms(Amplitudes r) {
  return (std::norm(r.s) + std::norm(r.p)) / 2;
}

// Fresnel's fractions in complex arithmetic; m is the quotient of the indices.
Complex quotient(Place at) {
  return {at.eta / at.n_here, at.k / at.n_here};
}
Amplitudes amplitudes(Place at, double squared_sin) {
  const Complex m = quotient(at);
  const Complex t = std::sqrt(1.0 - squared_sin / (m * m));  // the cosine beyond
  return {(at.c - m * t) / (at.c + m * t), (m * at.c - t) / (m * at.c + t)};
}
double exact(Place at) {
  return mean_of_norms(amplitudes(at, 1 - squared(at.c)));
}

// The same from q = a + i b, which is m times the cosine beyond, right or wrong.
double from_root(Place at, double squared_sin, Complex q) {
  const Complex s = (at.c - q) / (at.c + q);
  return mean_of_norms({s, s * (q * at.c - squared_sin) / (q * at.c + squared_sin)});
}
// Of thesis eq. 9 as printed: the outer index, divided by itself, stands in a and b for eta.
Complex printed_root(Place at, Complex square) {
  const double printed = square.real() - squared(quotient(at).real()) + 1;
  return {std::sqrt((std::abs(square) + printed) / 2), std::sqrt((std::abs(square) - printed) / 2)};
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

// What each mistake gives; sin2 is right, square the right (eta + i k)^2 - sin2.
struct Parts {
  Amplitudes r;
  double sin2;
  Complex square;
};
using Wrong = double (*)(Place at, Parts x);
const std::vector<std::pair<const char*, Wrong>> mistakes{
    {"k-forgotten",
     [](Place at, Parts) {
       return exact({at.c, at.n_here, at.eta, 0});
     }},
    {"cosine-not-squared", [](Place at, Parts) { return mean_of_norms(amplitudes(at, 1 - at.c)); }},
    {"cosine-not-squared",
     [](Place at, Parts x) {
       return from_root(at, 1 - at.c, std::sqrt(x.square + x.sin2 - (1 - at.c)));
     }},
    {"outside-forgotten",
     [](Place at, Parts) {
       return exact({at.c, 1, at.eta, at.k});
     }},
    {"k-not-divided",
     [](Place at, Parts) {
       return exact({at.c, at.n_here, at.eta, at.k * at.n_here});
     }},
    {"angle-ignored",
     [](Place at, Parts) {
       return exact({1, at.n_here, at.eta, at.k});
     }},
    {"cosine-taken-for-one", [](Place at, Parts) { return mean_of_norms(amplitudes(at, 0)); }},
    {"k-added",
     [](Place at, Parts x) {
       return from_root(at, x.sin2, std::sqrt(x.square + 2 * squared(quotient(at).imag())));
     }},
    {"imaginary-part-forgotten",
     [](Place at, Parts x) { return from_root(at, x.sin2, std::sqrt(Complex(x.square.real()))); }},
    {"printed-formula",
     [](Place at, Parts x) { return from_root(at, x.sin2, printed_root(at, x.square)); }},
    {"p-without-s",
     [](Place, Parts x) {
       return mean_of_norms({x.r.s, x.r.p / x.r.s});
     }},
    {"s-only", [](Place, Parts x) { return std::norm(x.r.s); }},
    {"sum-not-mean", [](Place, Parts x) { return 2 * mean_of_norms(x.r); }},
    {"not-squared", [](Place, Parts x) { return (std::abs(x.r.s) + std::abs(x.r.p)) / 2; }},
    // Conventions differ in the sign of one of the two.
    {"mean-before-square", [](Place, Parts x) { return std::norm(x.r.s + x.r.p) / 4; }},
    {"mean-before-square", [](Place, Parts x) { return std::norm(x.r.s - x.r.p) / 4; }},
    {"real-part-only",
     [](Place, Parts x) { return (squared(x.r.s.real()) + squared(x.r.p.real())) / 2; }},
    {"complex-square", [](Place, Parts x) { return (x.r.s * x.r.s + x.r.p * x.r.p).real() / 2; }},
    {"schlick",
     [](Place at, Parts) {
       const double straight_on = exact({1, at.n_here, at.eta, at.k});
       return straight_on + (1 - straight_on) * std::pow(1 - at.c, 5);
     }},
};

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
