#include "api.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

using std::numbers::pi;

namespace exercise {

double ggx_d(double alpha, glm::dvec3 h) {
  const double bracket = h.x * h.x + h.y * h.y + alpha * alpha * h.z * h.z;
  return alpha * alpha / (pi * bracket * bracket);
}

}  // namespace exercise

namespace {

using exercise::facet_pdf;
using exercise::ggx_d;
using exercise::sample_facet;
using exercise::sample_wi;
using exercise::wi_pdf;
using glm::dvec2;
using glm::dvec3;
using lt::text_of;
using lt::text_of_u;

const double alpha = 0.4;

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6 * std::max(1.0, std::abs(b));  // false for NaN
}

// Every u of a grid, its rim first.
std::vector<dvec2> places() {
  const std::array one{1 - 0x1p-53, 0.0, 0.03, 0.2, 0.4, 0.6, 0.8, 0.97};
  std::vector<dvec2> all;
  for (const double x : one)
    for (const double y : one)
      all.emplace_back(x, y);
  return all;
}
std::string facet_gave(dvec2 u) {
  return "sample_facet(0.4, (" + text_of_u(u.x) + ", " + text_of_u(u.y) + ")) gave " +
         text_of(sample_facet(alpha, u));
}

// A right answer fails as rarely with fewer samples, so that thousands of seeds need no minutes.
std::size_t sample_count() {
  return lt::seeds().size() == 1 ? 100'000 : 20'000;
}

double squared_tan(dvec3 w) {
  return (w.x * w.x + w.y * w.y) / (w.z * w.z);
}
double turn(dvec3 w) {  // 0 to 1, without its end
  return std::min(1 - 1e-12, std::atan2(-w.y, -w.x) / (2 * pi) + 0.5);
}
double part(double t, double width) {
  return t / (width + t);
}

// The share of the facets that lean less than w: each of these spreads one distribution evenly.
using Share = double (*)(dvec3 w);
double ggx_share(dvec3 w) {
  return part(squared_tan(w), alpha * alpha);
}
const std::array<std::pair<const char*, Share>, 5> mistakes{{
    {"root-forgotten", [](dvec3 w) { return part(std::sqrt(squared_tan(w)), alpha); }},
    {"alpha-not-squared", [](dvec3 w) { return part(squared_tan(w), alpha); }},
    {"alpha-squared-twice", [](dvec3 w) { return part(squared_tan(w), std::pow(alpha, 4)); }},
    {"beckmann-sampled", [](dvec3 w) { return 1 - std::exp(-squared_tan(w) / (alpha * alpha)); }},
    {"cosine-sampled", [](dvec3 w) { return 1 - w.z * w.z; }},
}};

// Facets counted in 16 x 16 cells of share and turn. At the end: how many fall beside it.
bool fits(const std::vector<dvec3>& all, Share share, double turns = 1) {
  std::vector<double> counts(257);
  std::vector<double> expected(256, static_cast<double>(all.size()) / 256);
  expected.push_back(0);
  for (const dvec3& w : all) {
    const dvec2 p(share(w), turns * turn(w));
    const bool is_inside = p.x >= 0 && p.x < 1 + 1e-9 && p.y < 1 + 1e-9;
    const dvec2 cell = min(floor(p * 16.0), dvec2(15));
    ++counts[is_inside ? static_cast<std::size_t>(cell.x * 16 + cell.y) : 256];
  }
  return lt::chi_square(counts, expected).p_value > 1e-6;
}

// Walter and others 2007, eqs. 14 and 24, of all that comes into them.
struct Parts {
  dvec3 o, i, h;
  double cosine, d;
  Parts(dvec3 to, dvec3 from)
      : o(to), i(from), h(normalize(to + from)), cosine(dot(to, h)), d(ggx_d(alpha, h)) {}
  [[nodiscard]] double pdf() const { return d * h.z / (4 * cosine); }
};
const dvec3 wo{0.6, 0, 0.8}, low{-0.48, 0.8, 0.36};
const std::array<Parts, 2> pairs{Parts(wo, {0.28, 0.576, 0.768}), Parts(low, wo)};

using Mistake = double (*)(const Parts& p);
const std::array<std::pair<const char*, Mistake>, 7> pdf_mistakes{{
    {"jacobian-missing", [](const Parts& p) { return p.d * p.h.z; }},
    {"jacobian-n-dot-o", [](const Parts& p) { return p.d * p.h.z / (4 * p.o.z); }},
    {"jacobian-without-four", [](const Parts& p) { return p.d * p.h.z / p.cosine; }},
    {"jacobian-four-alone", [](const Parts& p) { return p.d * p.h.z / 4; }},
    {"jacobian-multiplied", [](const Parts& p) { return p.d * p.h.z * 4 * p.cosine; }},
    {"cosine-lost", [](const Parts& p) { return p.d / (4 * p.cosine); }},
    {"pdf-of-wi-as-facet", [](const Parts& p) { return ggx_d(alpha, p.i) * p.i.z; }},
}};

std::string pdf_gave(dvec3 o, dvec3 i, double right) {
  return "wi_pdf(0.4, " + text_of(o) + ", " + text_of(i) + ") gave " +
         text_of(wi_pdf(alpha, o, i)) + " and should give " + text_of(right) + '.';
}

}  // namespace

TEST_CASE("every facet's normal is 1 long and faces up") {
  for (const dvec2 u : places()) {
    const dvec3 h = sample_facet(alpha, u);
    const bool is_finite = std::isfinite(h.x + h.y + h.z);
    lt::diagnose(is_finite || u.x * u.y != 0, "infinite-at-zero", facet_gave(u) + '.');
    INFO(facet_gave(u));
    REQUIRE((is_finite && h.z > 0));
    lt::diagnose(std::abs(length(h) - 1) < 1e-6, "not-unit",
                 facet_gave(u) + ", which is " + text_of(length(h)) + " long and should be 1.");
  }
  for (const auto& [a, b] :
       {std::pair(dvec2(0.3, 0.1), dvec2(0.3, 0.6)), std::pair(dvec2(0.1, 0.3), dvec2(0.6, 0.3))})
    lt::diagnose(distance(sample_facet(alpha, a), sample_facet(alpha, b)) > 1e-6,
                 "same-number-twice", facet_gave(a) + ", and " + facet_gave(b) + '.');
}

TEST_CASE("facets come in proportion to D times the cosine") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    std::vector<dvec3> all(sample_count());
    for (dvec3& h : all) {
      const double x = random.uniform();
      h = sample_facet(alpha, {x, random.uniform()});
    }
    if (fits(all, ggx_share)) continue;
    // (1/2)^2 / (1 + (1/2)^2) is 1/5.
    dvec2 percent(0);
    for (const dvec3& h : all)
      percent += dvec2(ggx_share(h) < 0.2, h.y < 0) * (100.0 / static_cast<double>(all.size()));
    const std::string seen = text_of(percent.x) + " % have a tangent below alpha / 2, and " +
                             text_of(percent.y) + " % a negative y; it should be 20 % and 50 %.";
    for (const auto& [tag, share] : mistakes)
      lt::diagnose(!fits(all, share), tag, seen);
    lt::diagnose(!fits(all, ggx_share, 2), "half-turn", seen);
    FAIL("256 cells are filled unevenly, by chi-square: " << seen);
  }
  for (const Parts& p : pairs) {
    const double value = facet_pdf(alpha, p.h);
    const std::string seen = "facet_pdf(0.4, " + text_of(p.h) + ") gave " + text_of(value) +
                             " and should give " + text_of(p.d * p.h.z) + '.';
    lt::diagnose(!is_near(value, p.d), "cosine-forgotten", seen);
    INFO(seen);
    REQUIRE(is_near(value, p.d * p.h.z));
  }
}

TEST_CASE("sample_wi mirrors wo at the facet, up or not at all") {
  const dvec3 flat{0.96, 0, 0.28};
  for (const dvec2 u : places()) {
    const dvec3 h = sample_facet(alpha, u);
    const double cosine = dot(flat, h);
    const dvec3 right = 2 * cosine * h - flat;
    const std::optional<dvec3> wi = sample_wi(alpha, flat, u);
    const std::string seen =
        "wo = " + text_of(flat) + " at a facet " + text_of(h) + " gave " +
        (wi ? text_of(*wi) : "nothing") + " and should give " +
        (right.z > 0 ? text_of(right) : "nothing, for it goes to " + text_of(right)) + '.';
    const auto is = [&](dvec3 w) { return wi && distance(*wi, w) < 1e-9; };
    lt::diagnose(!is(h), "facet-for-direction", seen);
    lt::diagnose(!is(-right) || sample_wi(alpha, flat, {0, 0}), "wrong-way", seen);
    lt::diagnose(cosine > 0 || !is(2 * std::abs(cosine) * h - flat), "absolute-cosine", seen);
    lt::diagnose(right.z > 0 || !is(right), "below-horizon", seen);
    lt::diagnose(!(right.z <= 0 && wi), "resampled", seen);
    INFO(seen);
    REQUIRE((right.z > 0 ? is(right) : !wi));
  }
}

TEST_CASE("wi_pdf is the facets' density over 4 (wo . h), and 0 below the horizon") {
  const auto is = [](Mistake formula) {
    return std::ranges::all_of(
        pairs, [&](const Parts& p) { return is_near(wi_pdf(alpha, p.o, p.i), formula(p)); });
  };
  // A wrong facet_pdf() has been named already and must not pass for another mistake.
  if (is_near(facet_pdf(alpha, low), ggx_d(alpha, low) * low.z))
    for (const auto& [tag, formula] : pdf_mistakes)
      lt::diagnose(!is(formula), tag, pdf_gave(wo, pairs[0].i, pairs[0].pdf()));
  for (const Parts& p : pairs) {
    INFO(pdf_gave(p.o, p.i, p.pdf()));
    REQUIRE(is_near(wi_pdf(alpha, p.o, p.i), p.pdf()));
  }
  for (const dvec3 below : {dvec3(0.6, 0, -0.8), dvec3(-0.8, 0.36, -0.48)})
    lt::diagnose(wi_pdf(alpha, wo, below) == 0, "pdf-below-horizon", pdf_gave(wo, below, 0));
}

TEST_CASE("mirrored directions are as dense as the density says, and as many as its sum") {
  // 8 heights times 12 turns, of 16 x 16 midpoints each. What is lost has a cell of its own.
  constexpr int rows = 8, columns = 12, fine = 16;
  const std::size_t samples = sample_count();
  const auto count = static_cast<double>(samples);
  std::vector<double> expected(rows * columns + 1);
  expected.back() = count;
  for (int k = 0; k < rows * columns * fine * fine; ++k) {
    const int row = k / (columns * fine), column = k % (columns * fine);
    const double z = (row + 0.5) / (rows * fine);
    const double phi = 2 * pi * (column + 0.5) / (columns * fine);
    const dvec3 wi(std::sqrt(1 - z * z) * dvec2(std::cos(phi), std::sin(phi)), z);
    const double share = Parts(low, wi).pdf() * 2 * pi / (rows * fine * columns * fine);
    expected[static_cast<std::size_t>(row / fine * columns + column / fine)] += count * share;
    expected.back() -= count * share;
  }
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    std::vector<double> counts(expected.size());
    for (std::size_t n = 0; n < samples; ++n) {
      const double x = random.uniform();
      const std::optional<dvec3> wi = sample_wi(alpha, low, {x, random.uniform()});
      const bool is_up = wi && wi->z > 0;
      const int row = is_up ? std::min(rows - 1, static_cast<int>(wi->z * rows)) : rows;
      const int column = is_up ? static_cast<int>(columns * turn(*wi)) : 0;
      ++counts[static_cast<std::size_t>(row * columns + column)];
    }
    INFO(counts.back() << " of " << count << " led nowhere; it should be " << expected.back());
    REQUIRE(lt::chi_square(counts, expected).p_value > 1e-6);
    if (seed != 1) continue;
    lt::measured("seen from 69 degrees at alpha 0.4, " + text_of(100 * counts.back() / count) +
                 " % of all facets lead nowhere");
  }
}
