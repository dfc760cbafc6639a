#include "api.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::coat_probability;
using exercise::Lobe;
using exercise::one_of_both;
using glm::dvec2, glm::dvec3;
using lt::text_of, lt::text_of_u;

const double almost_one = 1.0 - 0x1p-53;

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6 * std::max(1.0, std::abs(b));  // false for NaN
}
std::string gave(const std::string& what, double value, double right) {
  return what + " gave " + text_of(value) + " and should give " + text_of(right) + '.';
}
bool is_right(const std::string& what, double value, double right) {
  if (!is_near(value, right)) UNSCOPED_INFO(gave(what, value, right));
  return is_near(value, right);
}

// A coat that brings 3 and a base that brings 8, and what they were asked.
struct Asked {
  double value;
  std::vector<dvec2> coat, base;
};
Asked asked(double p, double z) {
  Asked result{};
  const auto coat = [&](dvec2 u) {
    result.coat.push_back(u);
    return 3.0;
  };
  const auto base = [&](dvec2 u) {
    result.base.push_back(u);
    return 8.0;
  };
  result.value = one_of_both(coat, base, p, {0.375, 0.625, z});
  return result;
}

struct Case {
  double p, z;
};
const std::array<Case, 7> cases{
    {{0.25, 0.125}, {0.25, 0.75}, {0.1, 0.05}, {0.1, 0.5}, {0.9, 0.5}, {0.9, 0.95}, {0.5, 0.25}}};
double right(const Case& c) {
  return c.z < c.p ? 3 / c.p : 8 / (1 - c.p);
}
std::string gave(const Case& c) {
  return gave("A coat that brings 3 and a base that brings 8, with p = " + text_of(c.p) +
                  " and u.z = " + text_of_u(c.z) + ',',
              asked(c.p, c.z).value, right(c));
}
using Formula = double (*)(const Case& c);
const std::array<std::pair<const char*, Formula>, 5> mistakes{{
    {"not-divided-by-p", [](const Case& c) { return c.z < c.p ? 3.0 : 8.0; }},
    {"divided-twice", [](const Case& c) { return right(c) / (c.z < c.p ? c.p : 1 - c.p); }},
    {"base-not-divided", [](const Case& c) { return c.z < c.p ? 3 / c.p : 8; }},
    {"divided-by-the-other", [](const Case& c) { return c.z < c.p ? 3 / (1 - c.p) : 8 / c.p; }},
    {"multiplied", [](const Case& c) { return c.z < c.p ? 3 * c.p : 8 * (1 - c.p); }},
}};

// How often to ask the coat, by a right or wrong rule.
using Rule = double (*)(double share, double tint);
double right_p(double share, double tint) {
  return share / (share + (1 - share) * tint);
}
const std::array<std::pair<const char*, Rule>, 5> rules{{
    {"share-alone", [](double share, double) { return share; }},
    {"rest-forgotten", [](double share, double tint) { return share / (share + tint); }},
    {"base-for-coat", [](double share, double tint) { return 1 - right_p(share, tint); }},
    {"half", [](double, double) { return 0.5; }},
    {"not-shared", [](double share, double tint) { return share / ((1 - share) * tint); }},
}};
const std::array<std::pair<double, double>, 4> coats{
    {{0.04, 0.5}, {0.25, 0.8}, {0.5, 0.125}, {0.0625, 0.75}}};

}  // namespace

TEST_CASE("one of the two is asked, with the numbers that are its own") {
  for (const auto& [p, z] : cases) {
    const Asked result = asked(p, z);
    const std::string at = "With p = " + text_of(p) + " and u.z = " + text_of(z) +
                           " the coat was asked " + std::to_string(result.coat.size()) +
                           " times and the base " + std::to_string(result.base.size()) + " times.";
    lt::diagnose(result.coat.empty() || result.base.empty(), "both-asked", at);
    const bool is_swapped =
        (z < p ? result.coat : result.base).empty() && result.coat.size() + result.base.size() == 1;
    lt::diagnose(!is_swapped, "choice-swapped", at);
    const std::vector<dvec2>& own = z < p ? result.coat : result.base;
    INFO(at);
    REQUIRE(own.size() == 1);
    std::ostringstream numbers;
    numbers << "Of u = (0.375, 0.625, " << z << ") the lobe got (" << own[0].x << ", " << own[0].y
            << ").";
    lt::diagnose(own[0].x != z && own[0].y != z, "number-used-twice", numbers.str());
    INFO(numbers.str());
    REQUIRE((is_near(own[0].x, 0.375) && is_near(own[0].y, 0.625)));
  }
}

TEST_CASE("what is asked seldom counts more") {
  bool is_one_asked = true;  // otherwise that has been named already
  for (const Case& c : cases) {
    const Asked result = asked(c.p, c.z);
    is_one_asked =
        is_one_asked && result.coat.size() == (c.z < c.p) && result.base.size() == (c.z >= c.p);
  }
  for (const Case& c : cases) {
    if (is_near(asked(c.p, c.z).value, right(c))) continue;
    for (const auto& [tag, formula] : mistakes) {
      const auto is = [f = formula](const Case& d) { return is_near(asked(d.p, d.z).value, f(d)); };
      lt::diagnose(!is_one_asked || !std::all_of(cases.begin(), cases.end(), is), tag, gave(c));
    }
    FAIL(gave(c));
  }
  for (const double z : {0.0, 0.5, almost_one})
    for (const double p : {0.0, 1.0}) {
      const Case c{p, z};
      lt::diagnose(std::isfinite(asked(p, z).value), "never-asked-lobe", gave(c));
      INFO(gave(c));
      REQUIRE(is_near(asked(p, z).value, right(c)));
    }
}

TEST_CASE("the mean is that of both together, whatever p is") {
  // Lobes with a noise of their own: means of 1 and 1.5.
  const auto coat = [](dvec2 u) { return 2 * u.x; };
  const auto base = [](dvec2 u) { return 6 * u.x * u.y; };
  std::ostringstream report;
  const int samples = lt::seeds().size() == 1 ? 50'000 : 10'000;
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (const double p : {0.1, 0.5, 0.9}) {
      lt::RunningMean mean;
      for (int i = 0; i < samples; ++i) {
        const double x = random.uniform(), y = random.uniform(), z = random.uniform();
        mean.add(one_of_both(coat, base, p, {x, y, z}));
      }
      INFO(gave("The mean with p = " + text_of(p), mean.mean(), 2.5));
      REQUIRE(lt::z_test(mean, 2.5).agrees(0.01));
      if (seed == 1)
        report << " " << mean.mean() << " +- " << mean.standard_error() << " with p = " << p << ';';
    }
  }
  lt::measured("coat 1 and base 1.5 together:" + report.str() + " and 2.5 is right");
}

TEST_CASE("the coat is asked in proportion to what it brings") {
  for (const auto& [tag, rule] : rules) {
    const auto is = [r = rule](const auto& coat) {
      return is_near(coat_probability(coat.first, coat.second), r(coat.first, coat.second));
    };
    lt::diagnose(
        !std::all_of(coats.begin(), coats.end(), is), tag,
        gave("coat_probability(0.25, 0.8)", coat_probability(0.25, 0.8), right_p(0.25, 0.8)));
  }
  for (const auto& [share, tint] : coats) {
    REQUIRE(is_right("coat_probability(" + text_of(share) + ", " + text_of(tint) + ')',
                     coat_probability(share, tint), right_p(share, tint)));
    // Under a sky of 1 both lobes bring their mean, and every estimate is that of both.
    const double coat = share, base = (1 - share) * tint;
    for (const double z : {0.0, 0.25, 0.5, 0.75, almost_one}) {
      const double value = one_of_both([=](dvec2) { return coat; }, [=](dvec2) { return base; },
                                       coat_probability(share, tint), {0.5, 0.5, z});
      REQUIRE(is_right("One estimate under a sky of 1", value, coat + base));
    }
  }
  REQUIRE(is_right("coat_probability(0, 0.5), without a coat,", coat_probability(0, 0.5), 0));
  REQUIRE(is_right("coat_probability(1, 0.5), a mirror,", coat_probability(1, 0.5), 1));
  REQUIRE(is_right("coat_probability(0.25, 0), over black,", coat_probability(0.25, 0), 1));
  const double nothing = coat_probability(0, 0);
  lt::diagnose(!std::isnan(nothing), "nan-without-light", "coat_probability(0, 0) gave nan.");
  INFO("coat_probability(0, 0) gave " << nothing << " and should give 0 to 1.");
  REQUIRE((nothing >= 0 && nothing <= 1));
}
