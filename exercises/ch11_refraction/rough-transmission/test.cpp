#include "api.hpp"
#include "formulas.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using namespace exercise;
using glm::dvec2, glm::dvec3;

const double pi = std::acos(-1.0);
const RoughGlass entering{{0.5}, 1, 1.5}, leaving{{0.5}, 1.5, 1};
// Directions with few digits, to the viewer and to the light below.
const std::array<std::pair<dvec3, dvec3>, 3> pairs{{{{0.6, 0, 0.8}, {-0.48, 0.36, -0.8}},
                                                    {{0, 0.28, 0.96}, {0.36, -0.48, -0.8}},
                                                    {{-0.48, -0.64, 0.6}, {0.36, 0.48, -0.8}}}};

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6 * std::max(1.0, std::abs(b));  // false for NaN
}
bool is_same(const std::optional<dvec3>& a, const std::optional<dvec3>& b) {
  return a && b && distance(*a, *b) < 1e-6;
}
std::string shown(double x) {
  std::ostringstream text;
  text << (std::isnan(x) ? std::abs(x) : x);  // "-nan" says no more than "nan"
  return text.str();
}
std::string shown(dvec3 v) {
  return '(' + shown(v.x) + ", " + shown(v.y) + ", " + shown(v.z) + ')';
}
std::string gave(double value, double right) {
  return " gave " + shown(value) + " and should give " + shown(right) + ". ";
}
std::string at(const RoughGlass& glass, dvec3 wo, dvec3 wi) {
  return " at alpha " + shown(glass.ggx.alpha) + ", index " + shown(glass.n_here) + " here and " +
         shown(glass.n_beyond) + " beyond, wo " + shown(wo) + ", wi " + shown(wi);
}
bool is_right(const std::string& what, double value, double right) {
  if (!is_near(value, right)) UNSCOPED_INFO(what << gave(value, right));
  return is_near(value, right);
}

// What was got for some directions has to be `right`, or is one of the mistakes.
struct Value {
  std::string what;
  Parts parts;
  double value;
};
void check(const std::vector<Value>& values, Formula right, const Mistakes& mistakes) {
  for (const auto& [what, parts, value] : values) {
    if (is_near(value, right(parts))) continue;
    for (const auto& [tag, formula] : mistakes)
      lt::diagnose(
          !std::all_of(values.begin(), values.end(),
                       [f = formula](const Value& v) { return is_near(v.value, f(v.parts)); }),
          tag, what + gave(value, right(parts)));
    FAIL(what + gave(value, right(parts)));
  }
}
using Function = double (*)(const RoughGlass& glass, dvec3 wo, dvec3 wi);
std::vector<Value> values_of(const std::string& name, Function function) {
  std::vector<Value> values;
  for (const RoughGlass& glass : {entering, leaving})
    for (const auto& [wo, wi] : pairs)
      values.push_back(
          {name + at(glass, wo, wi), *parts_of(glass, wo, wi), function(glass, wo, wi)});
  return values;
}

// Of directions below, in rows of equal height; then of those above; then of what leads nowhere.
constexpr int rows = 16, columns = 24, fine = 5;
std::vector<double> expected_shares(const RoughGlass& glass, dvec3 wo) {
  std::vector<double> shares(rows * columns, 1e-9);  // a bin at the edge may have no fine point
  shares.resize(rows * columns + 2);
  for (int i = 0; i < rows * fine; ++i)
    for (int k = 0; k < columns * fine; ++k) {
      const double z = -(i + 0.5) / (rows * fine), phi = 2 * pi * (k + 0.5) / (columns * fine);
      const double radius = std::sqrt(1 - z * z);
      const auto parts = parts_of(glass, wo, {radius * std::cos(phi), radius * std::sin(phi), z});
      if (!parts) continue;
      shares[static_cast<std::size_t>(i / fine * columns + k / fine)] +=
          2 * pi / (rows * fine * columns * fine) * right_pdf(*parts);
    }
  // Into the denser medium every facet bends the ray down.
  if (glass.n_here > glass.n_beyond)
    shares.back() = 1 - std::accumulate(shares.begin(), shares.end(), 0.0);
  return shares;
}
std::size_t bin_of(const std::optional<BsdfSample>& made) {
  if (!made) return rows * columns + 1;
  if (!(made->wi.z < 0) || std::isnan(made->wi.x + made->wi.y)) return rows * columns;
  const double turn = std::atan2(made->wi.y, made->wi.x) / (2 * pi) + 1;
  const int row = std::min(rows - 1, static_cast<int>(-made->wi.z * rows));
  return static_cast<std::size_t>(row * columns + static_cast<int>(turn * columns) % columns);
}

// The bin that is farthest off, in words.
std::string worst(const RoughGlass& glass, dvec3 wo, const std::vector<double>& counts,
                  const std::vector<double>& expected) {
  std::size_t most = 0;
  const auto off = [&](std::size_t i) {
    return square(counts[i] - expected[i]) / (expected[i] + 1);
  };
  for (std::size_t i = 0; i < counts.size(); ++i)
    most = off(i) > off(most) ? i : most;
  std::ostringstream text;
  text << "From index " << glass.n_here << " to " << glass.n_beyond << ", with wo " << shown(wo)
       << ", ";
  if (most == rows * columns + 1) text << "of all samples those that lead nowhere";
  if (most == rows * columns) text << "of all samples those that point up";
  if (most < rows * columns)
    text << "samples with z about " << -(static_cast<double>(most / columns) + 0.5) / rows
         << " and phi about " << (static_cast<double>(most % columns) + 0.5) * 360 / columns
         << " degrees";
  text << " number " << counts[most] << " and should number about " << expected[most] << '.';
  return text.str();
}

}  // namespace

TEST_CASE("the half vector follows from Snell's law, and points up") {
  for (const auto& [nh, nb] : {std::pair(1.0, 1.5), std::pair(1.5, 1.0)}) {
    const auto& [wo, wi] = pairs[0];
    const dvec3 h = transmission_half_vector(wo, wi, nh, nb), right = right_h(wo, wi, nh, nb);
    const std::string seen = "The half vector" + at({{0.5}, nh, nb}, wo, wi) + " gave " + shown(h) +
                             " and should give " + shown(right) + '.';
    const auto is_along = [&](dvec3 v) { return length(cross(h, normalize(v))) < 1e-6; };
    lt::diagnose(!is_along(wo + wi), "reflection-half-vector", seen);
    lt::diagnose(!is_along(nb * wo + nh * wi), "half-vector-indices", seen);
    lt::diagnose(!is_same(h, -right), "half-vector-side", seen);
    lt::diagnose(!is_along(right) || is_near(length(h), 1), "half-vector-not-unit", seen);
    if (!is_same(h, right)) FAIL(seen);
  }
}

TEST_CASE("eval and pdf: what comes through, and how dense directions lie") {
  check(values_of("eval", eval), right_eval, eval_mistakes);
  check(values_of("pdf", pdf), right_pdf, pdf_mistakes);
  // From above; and from below, but askew: facets show one of the two their back.
  const dvec3 high{0.6, 0, 0.8}, low{0.96, 0, 0.28}, above{0.48, 0.36, 0.8};
  for (const RoughGlass& glass : {entering, leaving})
    for (const auto& [wo, wi] : {std::pair(high, above), std::pair(high, dvec3(0.96, 0, -0.28)),
                                 std::pair(low, dvec3(0.6, 0, -0.8))}) {
      lt::diagnose(eval(glass, wo, wi) == 0, wi.z > 0 ? "same-side" : "back-of-facet",
                   "eval" + at(glass, wo, wi) + gave(eval(glass, wo, wi), 0));
      REQUIRE(is_right("pdf" + at(glass, wo, wi), pdf(glass, wo, wi), 0));
    }
}

TEST_CASE("sample bends the ray at the facet it draws, and weighs it") {
  const dvec3 wo{0.96, 0, 0.28};
  for (const RoughGlass& glass : {entering, leaving}) {
    const double eta = glass.n_here / glass.n_beyond;
    bool is_inverse = true, is_bent = true;
    std::string stray;
    std::vector<Value> weights;
    for (int i = 0; i < 400; ++i) {
      const dvec2 u{(i % 20 + 0.5) / 20, (i / 20 + 0.5) / 20};
      const auto made = sample(glass, wo, u);
      if (!made) continue;
      // A right answer may use u otherwise, and draw another facet.
      const dvec3 h = VisibleNormals::sample(glass.ggx, wo, u);
      const auto bent = refracted(wo, h, eta);
      const std::string what = "The weight of sample()" + at(glass, wo, made->wi);
      lt::diagnose(bent || !is_same(made->wi, 2 * dot(wo, h) * h - wo), "reflected-at-total",
                   "A sample" + at(glass, wo, made->wi) + ", where no ray gets through.");
      lt::diagnose(made->wi.z < 0 || !is_same(made->wi, bent), "goes-up",
                   "A sample" + at(glass, wo, made->wi) + '.');
      is_inverse = is_inverse && is_same(made->wi, refracted(wo, h, 1 / eta));
      const bool is_lost = !bent || bent->z >= 0;
      if (is_lost)
        stray = "A sample" + at(glass, wo, made->wi) +
                ", where the facet for these numbers leads nowhere.";
      is_bent = is_bent && (is_lost || is_same(made->wi, bent));
      if (const auto parts = parts_of(glass, wo, made->wi))
        weights.push_back({what, *parts, made->weight});
      REQUIRE(is_right("The pdf of sample()" + at(glass, wo, made->wi), made->pdf,
                       pdf(glass, wo, made->wi)));
    }
    lt::diagnose(!is_inverse, "eta-inverted", weights.empty() ? "" : weights[0].what + '.');
    lt::diagnose(!is_bent || stray.empty(), "redrawn", stray);
    check(weights, right_weight, weight_mistakes);
  }
}

TEST_CASE("directions come as the density says: chi-square over the whole sphere") {
  for (const auto& [glass, wo] :
       {std::pair(entering, dvec3(0.6, 0, 0.8)), std::pair(leaving, dvec3(0.6, 0, 0.8)),
        std::pair(entering, dvec3(0, 0.96, 0.28))}) {
    const std::vector<double> shares = expected_shares(glass, wo);
    for (const auto seed : lt::seeds()) {
      lt::TestRandom random(seed);
      const int count = lt::seeds().size() == 1 ? 40'000 : 5'000;
      std::vector<double> expected, counts(shares.size());
      for (const double share : shares)
        expected.push_back(count * share);
      for (int i = 0; i < count; ++i) {
        const double x = random.uniform(), y = random.uniform();
        ++counts[bin_of(sample(glass, wo, {x, y}))];
      }
      const lt::ChiSquare result = lt::chi_square(counts, expected);
      INFO(worst(glass, wo, counts, expected));
      REQUIRE(result.p_value >= 1e-6);
    }
  }
}

TEST_CASE("at random places: right, and the same both ways up to the squared index") {
  const auto turned = [](dvec3 w) { return dvec3(w.x, -w.y, -w.z); };
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      const double ratio = random.uniform(1.1, 2), alpha = random.uniform(0.1, 1);
      const RoughGlass glass{{alpha}, i % 2 == 0 ? ratio : 1, i % 2 == 0 ? 1 : ratio};
      const RoughGlass back{{alpha}, glass.n_beyond, glass.n_here};
      dvec3 wo = random.direction(), wi = random.direction();
      wo.z = std::abs(wo.z);
      wi.z = -std::abs(wi.z);
      const auto parts = parts_of(glass, wo, wi);
      const double value = eval(glass, wo, wi);
      REQUIRE(is_right("eval" + at(glass, wo, wi), value, parts ? right_eval(*parts) : 0));
      const double density = parts ? right_pdf(*parts) : 0;
      REQUIRE(is_right("pdf" + at(glass, wo, wi), pdf(glass, wo, wi), density));
      REQUIRE(is_right("eval / n_here^2 of both ways",
                       eval(back, turned(wi), turned(wo)) / square(back.n_here),
                       value / square(glass.n_here)));
    }
  }
  double in = 0, out = 0;
  for (int i = 0; i < 10'000; ++i) {
    const dvec2 u{(i % 100 + 0.5) / 100, (i / 100 + 0.5) / 100};
    const auto there = sample(entering, {0, 0, 1}, u), back = sample(leaving, {0, 0, 1}, u);
    in += there ? there->weight / 10'000 : 0;
    out += back ? back->weight / 10'000 : 0;
  }
  lt::measured("seen straight from above, frosted glass of alpha 0.5 shows " + shown(in) +
               " of the radiance within it, and from within " + shown(out) +
               " times the radiance outside");
}
