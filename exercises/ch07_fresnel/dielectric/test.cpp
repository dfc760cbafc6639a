#include "api.hpp"
#include "formulas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "common/testkit/exercise.hpp"

namespace {

using namespace oracle;
using exercise::fresnel_dielectric;
using exercise::reflectance_dielectric;

using std::numbers::pi;

double cos_of_degrees(double degrees) {
  return std::cos(degrees * pi / 180);
}

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6;  // double arithmetic is much closer; NaN never is
}
bool is_near(Reflectance a, Reflectance b) {
  return is_near(a.s, b.s) && is_near(a.p, b.p);
}

Reflectance given(Place at) {
  return reflectance_dielectric(at.c, at.n_here, at.n_beyond);
}

std::string text_of(double x) {
  return lt::text_of(std::abs(x) < 1e-12 ? 0 : x);  // no 2e-33
}
std::string text_of(Reflectance x) {
  return "s = " + text_of(x.s) + ", p = " + text_of(x.p);
}

std::string call_of(Place at) {
  return "at " + text_of(std::acos(std::min(1.0, at.c)) * 180 / pi) + " degrees (cosine " +
         text_of(at.c) + "), from index " + text_of(at.n_here) + " to " + text_of(at.n_beyond);
}

std::string gave(Place at) {
  return "The shares " + call_of(at) + ", gave " + text_of(given(at)) + " and should give " +
         text_of(exact(at)) + ".";
}

bool is_right(Place at) {
  const bool is_so = is_near(given(at), exact(at));
  if (!is_so) UNSCOPED_INFO(gave(at));
  return is_so;
}

// Into glass, out of water into glass, and out of glass: no total reflection among them.
const std::vector<Place> places{{0.8, 1, 1.5},  {0.96, 1, 1.5},   {0.6, 1, 1.5},    {0.28, 1, 1.5},
                                {0.9, 1, 1.33}, {0.8, 1.33, 1.5}, {0.3, 1.33, 1.5}, {0.8, 1.5, 1},
                                {0.96, 1.5, 1}, {0.8, 1.5, 1.33}};

template <class Question>
bool everywhere(const Question& question) {
  return std::all_of(places.begin(), places.end(), question);
}
bool is_right_everywhere() {
  return everywhere([](Place at) { return is_near(given(at), exact(at)); });
}

// Where a formula has no value, an answer that asks for total reflection says 1, others say NaN.
bool agrees(double value, double wrong) {
  if (std::isnan(wrong)) return std::isnan(value) || value == 1;
  return is_near(value, wrong);
}

template <class Formula>
bool made_by(const Formula& formula) {
  return everywhere([&](Place at) {
    const Reflectance wrong = formula(at);
    return agrees(given(at).s, wrong.s) && agrees(given(at).p, wrong.p);
  });
}

}  // namespace

TEST_CASE("both shares where there is an angle beyond") {
  if (!is_right_everywhere()) {
    const std::string seen = gave(places[0]);
    for (const auto& [tag, cosine] : wrong_cosines)
      lt::diagnose(!made_by([f = cosine](Place at) { return shares(at, f(at.c, eta_of(at))); }),
                   tag, seen);
    const auto turned = [](Place at) { return shares(back(at), snell(back(at))); };
    const auto sorted = [](Place at) {
      return at.n_here < at.n_beyond ? exact(at) : exact(back(at));
    };
    const auto exchanged = [](Place at) { return Reflectance{exact(at).p, exact(at).s}; };
    const auto copied = [](Place at) { return Reflectance{exact(at).s, exact(at).s}; };
    const auto is_root = [](Place at) {  // the sign of r is a convention
      return is_near({squared(given(at).s), squared(given(at).p)}, exact(at));
    };
    lt::diagnose(!made_by(turned), "sides-exchanged", seen);
    lt::diagnose(!made_by(sorted), "smaller-index-first", seen);
    lt::diagnose(!made_by(exchanged), "s-and-p-exchanged", seen);
    lt::diagnose(!made_by(copied), "s-twice", seen);
    lt::diagnose(!everywhere(is_root), "not-squared", seen);
  }
  for (const Place at : places)
    REQUIRE(is_right(at));
  // Straight on: ((n - 1) / (n + 1))^2 = 0.04 for glass, from both sides.
  for (const Place at : {Place{1, 1, 1.5}, Place{1, 1.5, 1}})
    REQUIRE((is_right(at) && is_near(given(at), {0.04, 0.04})));
  // Brewster: at tan = 1.5 the two rays stand square to each other, and p is gone.
  const Place brewster{1 / std::sqrt(1 + squared(1.5)), 1, 1.5};
  REQUIRE((is_right(brewster) && is_near(given(brewster).p, 0)));
}

TEST_CASE("beyond the critical angle all light is reflected") {
  for (const Place at : {Place{0.6, 1.5, 1}, Place{0.3, 1.5, 1.33}, Place{0.2, 1.33, 1}}) {
    const Reflectance value = given(at);
    const std::string seen = gave(at);
    const bool is_nan = std::isnan(value.s) && std::isnan(value.p);
    const double imaginary = std::sqrt(squared(eta_of(at)) * (1 - at.c * at.c) - 1);
    if (is_right_everywhere()) {
      lt::diagnose(!is_nan, "no-total-reflection", seen);
      lt::diagnose(!is_near(value, {0, 0}), "nothing-reflected", seen);
      lt::diagnose(!is_near(value, shares(at, imaginary)), "root-of-absolute", seen);
    }
    REQUIRE(is_right(at));
  }
  // sin = 1 / 1.5, 41.810 degrees: a tenth of a degree before it and after.
  REQUIRE(is_right({cos_of_degrees(41.71), 1.5, 1}));
  REQUIRE(is_right({cos_of_degrees(41.91), 1.5, 1}));
}

TEST_CASE("the rim: no surface, the horizon, a cosine that rounding left above 1") {
  for (const double c : {1.0, 0.5, 0.0}) {
    const Place none{c, 1.5, 1.5};
    const std::string seen = "Equal indices, " + call_of(none) + ", gave " + text_of(given(none)) +
                             " and should give s = 0, p = 0.";
    const bool is_known = std::isnan(given(none).s) || is_near(given(none), {1, 1});
    lt::diagnose(!is_known || !is_right_everywhere(), "equal-indices", seen);
    INFO(seen);
    REQUIRE(is_near(given(none), {0, 0}));
  }
  for (const Place at : {Place{0, 1, 1.5}, Place{0, 1.5, 1}})
    REQUIRE(is_right(at));
  const Place above{1 + 1e-9, 1, 1.5};
  const std::string seen = "A cosine of 1 + 1e-9, from index 1 to 1.5, gave " +
                           text_of(given(above)) + " and should give s = 0.04, p = 0.04.";
  lt::diagnose(!std::isnan(given(above).s) || !is_right_everywhere(), "cosine-above-one", seen);
  INFO(seen);
  REQUIRE(is_near(given(above), {0.04, 0.04}));
}

TEST_CASE("light of every swing: one share") {
  const auto fresnel = [](Place at) { return fresnel_dielectric(at.c, at.n_here, at.n_beyond); };
  const auto mean = [](Place at) { return (exact(at).s + exact(at).p) / 2; };
  const auto mean_gave = [&](Place at) {
    return "fresnel_dielectric() " + call_of(at) + ", gave " + text_of(fresnel(at)) +
           " and should give " + text_of(mean(at)) + " (" + text_of(exact(at)) + ").";
  };
  const auto diagnose = [&](const char* tag, auto formula) {
    const bool is_it = everywhere([&](Place at) { return is_near(fresnel(at), formula(at)); });
    lt::diagnose(!is_it, tag, mean_gave(places[0]));
  };
  if (is_right_everywhere()) {
    diagnose("s-only", [](Place at) { return exact(at).s; });
    diagnose("p-only", [](Place at) { return exact(at).p; });
    diagnose("sum-not-mean", [&](Place at) { return 2 * mean(at); });
    const auto is_mean_squared = [&](Place at) {  // conventions differ in the sign of r_p
      const double f = fresnel(at);
      return is_near(f, squared((r_s(at, snell(at)) + r_p(at, snell(at))) / 2)) ||
             is_near(f, squared((r_s(at, snell(at)) - r_p(at, snell(at))) / 2));
    };
    lt::diagnose(!everywhere(is_mean_squared), "mean-before-square", mean_gave(places[0]));
    diagnose("schlick", [](Place at) {
      const double straight_on = exact({1, at.n_here, at.n_beyond}).s;
      return straight_on + (1 - straight_on) * std::pow(1 - at.c, 5);
    });
  }
  for (const Place at : places) {
    INFO(mean_gave(at));
    REQUIRE(is_near(fresnel(at), mean(at)));
  }
}

TEST_CASE("any two media: as complex arithmetic has it, and alike from both ends of a ray") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 200; ++i) {
      const Place at{random.uniform(), random.uniform(1, 2.5), random.uniform(1, 2.5)};
      REQUIRE(is_right(at));
      const Place end{snell(at), at.n_beyond, at.n_here};
      if (end.c > 1e-3) REQUIRE(is_near(given(end), given(at)));
    }
  }
  std::ostringstream text;
  text << "glass of index 1.5 reflects " << fresnel_dielectric(1, 1, 1.5) << " straight on, "
       << fresnel_dielectric(cos_of_degrees(60), 1, 1.5) << " at 60 degrees and "
       << fresnel_dielectric(cos_of_degrees(85), 1, 1.5) << " at 85";
  lt::measured(text.str());
}
