#include "api.hpp"
#include "formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::smith_g1;
using exercise::smith_g2;
using exercise::smith_lambda;
using lt::text_of;
using namespace oracle;
using std::numbers::pi;

std::string lambda_gave(double alpha, dvec3 w) {
  return "smith_lambda(" + text_of(alpha) + ", " + text_of(w) + ')' +
         (w.z > 1 ? ", z being 1 + 2^-52," : "") + " gave " + text_of(smith_lambda(alpha, w)) +
         " and should give " + text_of(right_lambda(alpha, w)) + '.';
}

// One of the two shares, and what it should be.
struct Share {
  const char* name;
  double (*value)(double alpha, dvec3 a, dvec3 b);
  double (*right)(double alpha, dvec3 a, dvec3 b);
};
const Share g1{"smith_g1", smith_g1, right_g1};
const Share g2{"smith_g2", smith_g2, right_g2};

std::string gave(const Share& share, double alpha, dvec3 a, dvec3 b) {
  return share.name + ('(' + text_of(alpha)) + ", " + text_of(a) + ", " + text_of(b) + ") gave " +
         text_of(share.value(alpha, a, b)) + " and should give " +
         text_of(share.right(alpha, a, b)) + ".";
}
bool is_right(const Share& share, double alpha, dvec3 a, dvec3 b) {
  if (is_near(share.value(alpha, a, b), share.right(alpha, a, b))) return true;
  UNSCOPED_INFO(gave(share, alpha, a, b));
  return false;
}

// With few digits, 37 to 74 degrees from straight up, and a facet that all of them see.
const std::array<dvec3, 4> directions{
    {{0.48, 0.36, 0.8}, {-0.48, 0.64, 0.6}, {0.6, 0.64, 0.48}, {0.768, -0.576, 0.28}}};
const dvec3 facet{0, 0.28, 0.96};

bool lambda_is(Lambda formula) {
  for (const double alpha : {0.2, 0.5, 0.9})
    for (const dvec3 w : directions)
      if (!is_near(smith_lambda(alpha, w), formula(alpha, w))) return false;
  return true;
}

// What is seen along w of all facets that show their front: Simpson's rule around the turn.
double seen_area(double alpha, double theta_w) {
  const dvec3 w{std::sin(theta_w), 0, std::cos(theta_w)};
  const auto ring = [&](double theta) {
    // m faces w where cos(phi) > -cot(theta) cot(theta_w).
    const double end = std::acos(std::max(-1.0, -w.z / w.x / std::tan(std::max(1e-9, theta))));
    const int pieces = 24;
    double sum = 0;
    for (int i = 0; i <= pieces; ++i) {
      const double phi = end * i / pieces;
      const dvec3 m(std::sin(theta) * glm::dvec2(std::cos(phi), std::sin(phi)), std::cos(theta));
      const double weight = i == 0 || i == pieces ? 1 : 2 + 2 * (i % 2);
      sum += weight * smith_g1(alpha, w, m) * std::max(0.0, dot(w, m));
    }
    const double stretched = std::hypot(std::sin(theta) / alpha, std::cos(theta));
    const double d = std::pow(stretched, -4) / (pi * alpha * alpha);
    return 2 * sum * end / (3 * pieces) * d * std::sin(theta);
  };
  const double kink = pi / 2 - theta_w;
  return lt::integrate(ring, 0, kink, 1e-6) + lt::integrate(ring, kink, pi / 2, 1e-6);
}

}  // namespace

TEST_CASE("smith_lambda says how much is hidden for each unit that is seen") {
  for (const auto& [tag, formula] : lambda_mistakes)
    lt::diagnose(!lambda_is(formula), tag, lambda_gave(0.5, directions[0]));
  // Rounding lets the z of a unit vector exceed 1 by a hair.
  const dvec3 hair{1e-9, 0, 1 + 0x1p-52};
  lt::diagnose(!std::isnan(smith_lambda(0.5, hair)), "cosine-beyond-one", lambda_gave(0.5, hair));
  for (const double alpha : {0.2, 0.5, 0.9})
    for (const dvec3 w : directions)
      for (const dvec3 side : {w, -w, dvec3(0, 0, 1), hair}) {
        INFO(lambda_gave(alpha, side));
        REQUIRE(is_near(smith_lambda(alpha, side), right_lambda(alpha, side)));
      }
}

TEST_CASE("smith_g1 is what is seen of facets that face one") {
  const auto is = [](Pair formula) {
    return std::ranges::all_of(directions, [&](dvec3 w) {
      return is_near(smith_g1(0.5, w, facet), formula(0.5, w, facet));
    });
  };
  // A wrong smith_lambda() has been named already and must not pass for another mistake.
  if (lambda_is(right_lambda))
    for (const auto& [tag, formula] : g1_mistakes)
      lt::diagnose(!is(formula), tag, gave(g1, 0.5, directions[1], facet));
  REQUIRE(is_right(g1, 0.5, directions[1], facet));

  const dvec3 flat{0.96, 0, 0.28}, away{-0.8, 0, 0.6};  // flat sees the back of this facet
  lt::diagnose(smith_g1(0.5, flat, away) == 0, "backfacing-facet", gave(g1, 0.5, flat, away));
  lt::diagnose(smith_g1(0.5, -flat, facet) != 0, "side-forgotten", gave(g1, 0.5, -flat, facet));
  REQUIRE((is_right(g1, 0.5, -flat, facet) && is_right(g1, 0.5, -flat, away)));
}

TEST_CASE("smith_g2 is what is both seen and lit") {
  const dvec3 wo = directions[1], wi = directions[3];
  const auto is = [&](Pair formula) {
    return is_near(smith_g2(0.5, wo, wi), formula(0.5, wo, wi)) &&
           is_near(smith_g2(0.5, wi, wo), formula(0.5, wi, wo)) &&
           is_near(smith_g2(0.9, wo, facet), formula(0.9, wo, facet));
  };
  if (lambda_is(right_lambda))
    for (const auto& [tag, formula] : g2_mistakes)
      lt::diagnose(!is(formula), tag, gave(g2, 0.5, wo, wi));
  REQUIRE(is_right(g2, 0.5, wo, wi));
  for (const auto& [a, b] : {std::pair(wo, -wi), std::pair(-wo, wi)})
    lt::diagnose(smith_g2(0.5, a, b) == 0, "through-the-surface", gave(g2, 0.5, a, b));
  lt::diagnose(smith_g2(0.5, -wo, -wi) != 0, "both-below", gave(g2, 0.5, -wo, -wi));
  REQUIRE(is_right(g2, 0.5, -wo, -wi));
}

TEST_CASE("along the surface nothing is seen, and straight from above all is") {
  const dvec3 up{0, 0, 1}, level{1, 0, 0}, across{0, -1, 0}, low{1, 0, 1e-7};
  for (const dvec3 b : {across, up, level}) {
    lt::diagnose(!std::isnan(smith_g1(0.5, level, b)), "nan-at-grazing", gave(g1, 0.5, level, b));
    REQUIRE(is_right(g1, 0.5, level, b));
    for (const auto& [wo, wi] : {std::pair(level, b), std::pair(b, level)}) {
      lt::diagnose(!std::isnan(smith_g2(0.5, wo, wi)), "nan-at-grazing", gave(g2, 0.5, wo, wi));
      REQUIRE(is_right(g2, 0.5, wo, wi));
    }
  }
  for (const dvec3 w : {up, low})
    REQUIRE((is_right(g1, 0.5, w, up) && is_right(g2, 0.5, w, up)));
}

TEST_CASE("what is seen of the facets is as large as the surface looks") {
  for (const double alpha : {0.1, 0.5, 1.0})
    for (int degrees = 5; degrees <= 85; degrees += 10) {
      INFO("Seen from " << degrees << " degrees, alpha being " << alpha << ':');
      const double theta = degrees * pi / 180;
      REQUIRE(seen_area(alpha, theta) == lt::close_to(std::cos(theta), 1e-5));
    }
}

TEST_CASE("at random places: right, the same both ways, and never more than either sees") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 200; ++i) {
      const double alpha = random.uniform(0.01, 1);
      const dvec3 wo = random.direction();
      const dvec3 wi = random.direction();
      for (const auto& [a, b] : {std::pair(wo, wi), std::pair(wi, wo)})
        REQUIRE((is_right(g1, alpha, a, b) && is_right(g2, alpha, a, b)));
      REQUIRE(smith_g2(alpha, wo, wi) <= smaller(alpha, wo, wi) + 1e-9);
    }
  }
  const dvec3 low = normalize(dvec3(6, 0, 1));
  lt::measured("9.5 degrees above the horizon at alpha 0.5, " +
               text_of(100 * smith_g1(0.5, low, low)) + " % are seen, and " +
               text_of(100 * smith_g2(0.5, low, low)) + " % both seen and lit");
}
