#include "api.hpp"
#include "formulas.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using namespace oracle;
using glm::dvec2, glm::dvec3;

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
std::string gave(double value, double right) {
  return " gave " + text_of(value) + " and should give " + text_of(right) + ". ";
}
std::string at(const RoughGlass& glass, dvec3 wo, dvec3 wi) {
  return " at alpha " + text_of(glass.ggx.alpha) + ", index " + text_of(glass.n_here) +
         " here and " + text_of(glass.n_beyond) + " beyond, wo " + text_of(wo) + ", wi " +
         text_of(wi);
}
bool is_right(const std::string& what, double value, double right) {
  if (!is_near(value, right)) UNSCOPED_INFO(what << gave(value, right));
  return is_near(value, right);
}

using Mistakes = std::vector<std::pair<const char*, Formula>>;
const Mistakes eval_mistakes{
    {"reflection-denominator", [](P p) { return p.through * p.d * p.g2 / (4 * p.mo * p.mi); }},
    {"fresnel-not-subtracted", [](P p) { return right_eval(p) / p.through * (1 - p.through); }},
    {"fresnel-twice", [](P p) { return right_eval(p) * (1 - p.through); }},
    {"fresnel-at-normal", [](P p) { return right_eval(p) / p.through * p.through_flat; }},
    {"importance-for-radiance", [](P p) { return right_eval(p) * square(p.nb / p.nh); }},
    {"sum-not-squared", [](P p) { return right_eval(p) * p.sum; }},
    {"sum-of-sizes", [](P p) { return right_eval(p) * wrong_sum(p); }},
    {"cosines-forgotten", [](P p) { return right_eval(p) * p.mo * p.mi; }},
    {"cosine-included", [](P p) { return right_eval(p) * p.mi; }},
    {"facet-cosines-forgotten", [](P p) { return right_eval(p) / (p.co * p.ci); }},
};
const Mistakes pdf_mistakes{
    {"reflection-jacobian", [](P p) { return facet_pdf(p) / (4 * p.co); }},
    {"jacobian-forgotten", facet_pdf},
    {"jacobian-index", [](P p) { return right_pdf(p) * square(p.nh / p.nb); }},
    {"jacobian-cosine", [](P p) { return right_pdf(p) * p.co / p.ci; }},
    {"jacobian-not-squared", [](P p) { return right_pdf(p) * p.sum; }},
    {"jacobian-of-sizes", [](P p) { return right_pdf(p) * wrong_sum(p); }},
    {"pdf-with-fresnel", [](P p) { return right_pdf(p) * p.through; }},
};
const Mistakes weight_mistakes{
    {"weight-unscaled", [](P p) { return right_weight(p) * square(p.nb / p.nh); }},
    {"weight-without-fresnel", [](P p) { return right_weight(p) / p.through; }},
    {"weight-without-cosine", [](P p) { return right_weight(p) / p.mi; }},
    {"weight-masked-twice", [](P p) { return right_weight(p) * p.g1; }},
};

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

}  // namespace

TEST_CASE("the half vector follows from Snell's law, and points up") {
  for (const auto& [nh, nb] : {std::pair(1.0, 1.5), std::pair(1.5, 1.0)}) {
    const auto& [wo, wi] = pairs[0];
    const dvec3 h = transmission_half_vector(wo, wi, nh, nb), right = right_h(wo, wi, nh, nb);
    const std::string seen = "The half vector" + at({{0.5}, nh, nb}, wo, wi) + " gave " +
                             text_of(h) + " and should give " + text_of(right) + '.';
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
  lt::measured("seen straight from above, frosted glass of alpha 0.5 shows " + text_of(in) +
               " of the radiance within it, and from within " + text_of(out) +
               " times the radiance outside");
}
