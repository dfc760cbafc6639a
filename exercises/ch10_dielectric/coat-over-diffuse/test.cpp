#include "api.hpp"
#include "formulas.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using namespace oracle;
using glm::dvec2, glm::dvec3;

// Directions with few digits.
const std::array<std::pair<dvec3, dvec3>, 3> pairs{{{{0.6, 0, 0.8}, {-0.48, 0.64, 0.6}},
                                                    {{0, 0.96, 0.28}, {0.36, -0.48, 0.8}},
                                                    {{-0.48, -0.36, 0.8}, {0.768, 0.576, 0.28}}}};

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6 * std::max(1.0, std::abs(b));  // false for NaN
}
bool is_same(const std::optional<dvec3>& a, const std::optional<dvec3>& b) {
  return a && b && distance(*a, *b) < 1e-9;
}
std::string at(dvec3 wo, dvec3 wi) {
  return " with tint 0.75, alpha 0.4, ior 1.5, wo " + text_of(wo) + ", wi " + text_of(wi);
}
std::string gave(double value, double right) {
  return " gave " + text_of(value) + " and should give " + text_of(right) + '.';
}

using Mistakes = std::vector<std::pair<const char*, Formula>>;
const Mistakes eval_mistakes{
    {"base-not-attenuated", [](P p) { return p.coat + p.base; }},
    {"attenuated-once", [](P p) { return p.coat + p.base * p.in; }},
    {"attenuated-once", [](P p) { return p.coat + p.base * p.out; }},
    {"fresnel-at-facet", [](P p) { return p.coat + p.base * p.at_facet * p.at_facet; }},
    {"reflected-for-rest", [](P p) { return p.coat + p.base * (1 - p.in) * (1 - p.out); }},
    {"pi-forgotten", [](P p) { return p.coat + pi * p.base * p.in * p.out; }},
    {"coat-forgotten", [](P p) { return p.base * p.in * p.out; }},
    {"coat-fresnel-twice", [](P p) { return p.coat * (1 - p.out) + p.base * p.in * p.out; }},
    {"coat-tinted", [](P p) { return p.coat * red.tint + p.base * p.in * p.out; }},
    {"cosine-included", [](P p) { return right_eval(p) * p.mi; }},
};
const Mistakes pdf_mistakes{
    {"probabilities-swapped", [](P p) { return (1 - p.p) * p.coat_pdf + p.p * p.base_pdf; }},
    {"equal-probabilities", [](P p) { return (p.coat_pdf + p.base_pdf) / 2; }},
    {"densities-added", [](P p) { return p.coat_pdf + p.base_pdf; }},
};
const Mistakes weight_mistakes{
    {"weight-without-cosine", [](P p) { return right_weight(p) / p.mi; }},
    {"weight-with-cosine-of-wo", [](P p) { return right_weight(p) * p.mo / p.mi; }},
    {"weight-not-divided", [](P p) { return right_weight(p) * right_pdf(p); }},
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
    for (const auto& [tag, formula] : mistakes) {
      const auto is = [f = formula](const Value& v) { return is_near(v.value, f(v.parts)); };
      lt::diagnose(!std::all_of(values.begin(), values.end(), is), tag,
                   what + gave(value, right(parts)));
    }
    FAIL(what + gave(value, right(parts)));
  }
}
using Function = double (*)(const CoatedBase& material, dvec3 wo, dvec3 wi);
std::vector<Value> values_of(const std::string& name, Function function) {
  std::vector<Value> values;
  for (const auto& [wo, wi] : pairs)
    values.push_back({name + at(wo, wi), parts_of(wo, wi), function(red, wo, wi)});
  return values;
}

// Even over the unit cube, without chance (Roberts 2018).
dvec3 numbers(int i) {
  return fract(0.5 + (i + 1.0) * dvec3(0.8191725134, 0.6710436067, 0.5497004779));
}

}  // namespace

TEST_CASE("eval: the coat, and the base seen through it twice") {
  check(values_of("eval", eval), right_eval, eval_mistakes);
  const dvec3 up{0.6, 0, 0.8}, down{0.48, 0.64, -0.6};
  for (const auto& [wo, wi] : {std::pair(up, down), std::pair(down, up), std::pair(down, -up)})
    lt::diagnose(eval(red, wo, wi) == 0, "through-the-surface",
                 "eval" + at(wo, wi) + gave(eval(red, wo, wi), 0));
}

TEST_CASE("pdf: either way may have led there") {
  check(values_of("pdf", pdf), right_pdf, pdf_mistakes);
  const dvec3 up{0.6, 0, 0.8}, down{0.48, 0.64, -0.6};
  lt::diagnose(pdf(red, up, down) == 0, "pdf-below-horizon",
               "pdf" + at(up, down) + gave(pdf(red, up, down), 0));
}

TEST_CASE("sample: one of two ways, weighed as both") {
  const dvec3 wo{0, 0.8, 0.6};
  const double p = coat_probability(red, wo);
  bool is_chosen_pdf = true, is_chosen_weight = true;
  bool is_swapped = true, is_shared = true, is_straight = true;
  std::string lost, wrong_pdf;
  std::vector<Value> weights;
  for (int i = 0; i < 500; ++i) {
    const dvec3 u = numbers(i);
    const auto made = sample(red, wo, u);
    const auto coat = coat_sample(red, wo, dvec2(u));
    const dvec3 base = cosine_hemisphere(dvec2(u));
    if (!made) continue;
    // A right answer may use u otherwise, and then none of these is true.
    is_swapped = is_swapped && is_same(made->wi, u.z < p ? base : coat);
    is_shared = is_shared && is_same(made->wi, u.x < p ? coat : base);
    if (u.z < p && !coat)
      lost = "wi" + at(wo, made->wi) + ", where the coat gives no direction.";
    else
      is_straight = is_straight && is_same(made->wi, u.z < p ? coat : base);
    const Parts parts = parts_of(wo, made->wi);
    const auto is_one_of = [](double value, double a, double b) {
      return is_near(value, a) || is_near(value, b);
    };
    is_chosen_pdf =
        is_chosen_pdf && (is_one_of(made->pdf, parts.coat_pdf, parts.base_pdf) ||
                          is_one_of(made->pdf, p * parts.coat_pdf, (1 - p) * parts.base_pdf));
    if (!is_near(made->pdf, pdf(red, wo, made->wi)))
      wrong_pdf = "The pdf of a sample" + at(wo, made->wi) + gave(made->pdf, right_pdf(parts));
    const double scale = parts.mi / right_pdf(parts);
    is_chosen_weight = is_chosen_weight && is_one_of(made->weight, parts.coat * scale,
                                                     parts.base * parts.in * parts.out * scale);
    weights.push_back({"The weight of a sample" + at(wo, made->wi), parts, made->weight});
  }
  REQUIRE(!weights.empty());
  lt::diagnose(!is_swapped, "choice-swapped", "At u.z below " + text_of(p) + '.');
  lt::diagnose(!is_shared, "choice-shared", "At u.x below " + text_of(p) + '.');
  lt::diagnose(!is_straight || lost.empty(), "base-for-lost-coat", lost);
  lt::diagnose(wrong_pdf.empty() || !is_chosen_pdf, "pdf-of-chosen-lobe-only", wrong_pdf);
  if (!wrong_pdf.empty()) FAIL(wrong_pdf);
  const auto& [a, b] = pairs[0];  // a wrong eval() has been named already
  is_chosen_weight = is_chosen_weight && is_near(eval(red, a, b), right_eval(parts_of(a, b)));
  lt::diagnose(!is_chosen_weight, "weight-of-chosen-lobe-only",
               weights[0].what + gave(weights[0].value, right_weight(weights[0].parts)));
  check(weights, right_weight, weight_mistakes);
}

TEST_CASE("directions come as the density says: chi-square of the mixture") {
  for (const dvec3 wo : {dvec3(0.6, 0, 0.8), dvec3(0, 0.96, 0.28)}) {
    const std::vector<double> shares = expected_shares(wo);
    for (const auto seed : lt::seeds()) {
      lt::TestRandom random(seed);
      const int count = lt::seeds().size() == 1 ? 50'000 : 5'000;
      std::vector<double> expected, counts(shares.size());
      for (const double share : shares)
        expected.push_back(count * share);
      for (int i = 0; i < count; ++i) {
        const double x = random.uniform(), y = random.uniform(), z = random.uniform();
        ++counts[bin_of(sample(red, wo, {x, y, z}))];
      }
      INFO(worst(wo, counts, expected));
      REQUIRE(lt::chi_square(counts, expected).p_value >= 1e-6);
    }
  }
}

TEST_CASE("a white base in a furnace: what the coat leaves comes back") {
  // E is the coat's albedo, from its own samples: F G2 / G1. The base adds (1 - F) times the mean
  // of 1 - F over the cosine: 1 - 0.0917780 at index 1.5.
  const CoatedBase white{1, 0.05, 1.5};
  std::ostringstream report;
  for (int k = 0; k < 9; ++k) {
    const double theta = k * 70.0 / 8 * pi / 180;
    const dvec3 wo{std::sin(theta), 0, std::cos(theta)};
    constexpr int count = 8000;
    double sum = 0, coat = 0;
    for (int i = 0; i < count; ++i) {
      const auto made = sample(white, wo, numbers(i));
      sum += made ? made->weight / count : 0;
      const auto wi = coat_sample(white, wo, dvec2(numbers(i)));
      coat += wi ? coat_eval(white, wo, *wi) * wi->z / coat_pdf(white, wo, *wi) / count : 0;
    }
    const double right = coat + (1 - fresnel(white, wo.z)) * (1 - 0.0917780);
    INFO("The albedo at " << k * 70.0 / 8 << " degrees" << gave(sum, right));
    REQUIRE(std::abs(sum - right) < 0.01);
    REQUIRE(sum > 0.9);
    REQUIRE(sum < 1);
    report << (k == 0 ? "" : ", ") << sum;
  }
  lt::measured("seen from 0 to 70 degrees, a white base under the coat sends back " + report.str());
}

TEST_CASE("at random places: right, and the same both ways") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 100; ++i) {
      const dvec3 a = random.direction(), b = random.direction();
      const dvec3 wo{a.x, a.y, std::abs(a.z)}, wi{b.x, b.y, std::abs(b.z)};
      const Parts parts = parts_of(wo, wi);
      INFO("eval" << at(wo, wi) << gave(eval(red, wo, wi), right_eval(parts))
                  << " The way back gave " << eval(red, wi, wo) << ". pdf"
                  << gave(pdf(red, wo, wi), right_pdf(parts)));
      REQUIRE(is_near(eval(red, wo, wi), right_eval(parts)));
      REQUIRE(is_near(eval(red, wi, wo), eval(red, wo, wi)));
      REQUIRE(is_near(pdf(red, wo, wi), right_pdf(parts)));
    }
  }
}
