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

using std::numbers::pi;

namespace exercise {

namespace {

double lambda(double alpha, glm::dvec3 w) {
  return (std::hypot(1, alpha * std::hypot(w.x, w.y) / w.z) - 1) / 2;
}
}  // namespace

double ggx_d(double alpha, glm::dvec3 h) {
  const double bracket = h.x * h.x + h.y * h.y + alpha * alpha * h.z * h.z;
  return alpha * alpha / (pi * bracket * bracket);
}
double smith_g2(double alpha, glm::dvec3 wo, glm::dvec3 wi) {
  return 1 / (1 + lambda(alpha, wo) + lambda(alpha, wi));
}
glm::dvec3 sample_facet(double alpha, glm::dvec2 u) {
  const double tan = alpha * std::sqrt(u.x / (1 - u.x));
  return normalize(glm::dvec3(tan * glm::dvec2(std::cos(2 * pi * u.y), std::sin(2 * pi * u.y)), 1));
}

}  // namespace exercise

namespace {

using exercise::ggx_d;
using exercise::ggx_sample;
using exercise::lambda;
using exercise::Sample;
using exercise::sample_facet;
using exercise::smith_g2;
using glm::dvec2;
using glm::dvec3;
using lt::text_of;

const double alpha = 0.4;
const dvec3 wo{0.48, -0.64, 0.6}, flat{0.96, 0, 0.28};

// Facets whose share tells the cosine that was asked for.
double telling(double cosine) {
  return 0.1 + 0.6 * cosine * cosine;
}

// Walter and others 2007, eqs. 14, 20, 24 and 39, of all that comes into them.
struct Parts {
  dvec3 o, h, i;
  double cosine, d, g;
  Parts(dvec3 to, dvec2 u)
      : o(to),
        h(sample_facet(alpha, u)),
        i(2 * dot(to, h) * h - to),
        cosine(dot(to, h)),
        d(ggx_d(alpha, h)),
        g(smith_g2(alpha, to, i)) {}
  [[nodiscard]] double f() const { return telling(cosine) * d * g / (4 * o.z * i.z); }
  [[nodiscard]] double pdf() const { return d * h.z / (4 * cosine); }
  [[nodiscard]] double weight() const { return f() * i.z / pdf(); }
};

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6 * std::max(1.0, std::abs(b));  // false for NaN
}
std::string facing(const Parts& p) {
  return "wo = " + text_of(p.o) + " at a facet " + text_of(p.h) + ", alpha 0.4,";
}

// Places whose facets mirror wo up.
const std::vector<dvec2> up{{0.1, 0.2}, {0.4, 0.9}, {0.25, 0.55}, {0.6, 0.8}};

using Mistake = double (*)(const Parts& p);
// What stands for F, the rest being right.
double with_share(const Parts& p, double share) {
  return p.weight() / telling(p.cosine) * share;
}
const std::array<std::pair<const char*, Mistake>, 7> pdf_mistakes{{
    {"jacobian-missing", [](const Parts& p) { return p.d * p.h.z; }},
    {"jacobian-n-dot-o", [](const Parts& p) { return p.d * p.h.z / (4 * p.o.z); }},
    {"jacobian-without-four", [](const Parts& p) { return p.d * p.h.z / p.cosine; }},
    {"jacobian-four-alone", [](const Parts& p) { return p.d * p.h.z / 4; }},
    {"cosine-of-h-lost", [](const Parts& p) { return p.d / (4 * p.cosine); }},
    {"cosine-sampled", [](const Parts& p) { return p.i.z / pi; }},
    {"cosine-sampled", [](const Parts& p) { return p.h.z / pi; }},
}};
const std::array<std::pair<const char*, Mistake>, 17> weight_mistakes{{
    {"cosine-of-wo", [](const Parts& p) { return p.f() * p.o.z / p.pdf(); }},
    {"cosine-forgotten", [](const Parts& p) { return p.f() / p.pdf(); }},
    {"cosine-of-h", [](const Parts& p) { return p.f() * p.h.z / p.pdf(); }},
    {"cosine-at-the-facet", [](const Parts& p) { return p.f() * p.cosine / p.pdf(); }},
    {"four-forgotten", [](const Parts& p) { return 4 * p.weight(); }},
    {"cosine-left-out", [](const Parts& p) { return p.weight() * p.h.z; }},
    {"cosine-left-out", [](const Parts& p) { return p.weight() * p.o.z; }},
    {"pdf-of-the-facet", [](const Parts& p) { return p.f() * p.i.z / (p.d * p.h.z); }},
    {"pdf-forgotten", [](const Parts& p) { return p.f() * p.i.z; }},
    {"pdf-multiplied", [](const Parts& p) { return p.f() * p.i.z * p.pdf(); }},
    {"fresnel-alone", [](const Parts& p) { return telling(p.cosine); }},
    {"fresnel-forgotten", [](const Parts& p) { return with_share(p, 1); }},
    {"fresnel-from-n-dot-o", [](const Parts& p) { return with_share(p, telling(p.o.z)); }},
    {"fresnel-from-n-dot-h", [](const Parts& p) { return with_share(p, telling(p.h.z)); }},
    {"g-forgotten", [](const Parts& p) { return p.weight() / p.g; }},
    {"weight-of-visible-normals",
     [](const Parts& p) { return telling(p.cosine) * p.g * (1 + lambda(alpha, p.o)); }},
    {"weight-of-visible-normals",
     [](const Parts& p) { return telling(p.cosine) / (1 + lambda(alpha, p.i)); }},
}};

bool is(double Sample::*member, Mistake formula) {
  return std::ranges::all_of(up, [&](dvec2 u) {
    const std::optional<Sample> sample = ggx_sample(alpha, telling, wo, u);
    return sample && is_near((*sample).*member, formula(Parts(wo, u)));
  });
}

// The first place's value of pdf or weight.
std::string gave(const std::string& name, double value, double right) {
  return facing(Parts(wo, up[0])) + " gave a " + name + " of " + text_of(value) +
         " and should give " + text_of(right) + '.';
}

}  // namespace

TEST_CASE("wi is where the facet mirrors wo, or there is none") {
  for (const double x : {0.999, 0.97, 0.8, 0.6, 0.4, 0.2, 0.02})
    for (const double y : {0.01, 0.2, 0.4, 0.52, 0.6, 0.8}) {
      const Parts p(flat, {x, y});
      const std::optional<Sample> sample = ggx_sample(alpha, telling, flat, {x, y});
      const std::string seen =
          facing(p) + " gave " + (sample ? text_of(sample->wi) : "nothing") + " and should give " +
          (p.i.z > 0 ? text_of(p.i) : "nothing, for it goes to " + text_of(p.i)) + '.';
      const auto is_wi = [&](dvec3 w) { return sample && distance(sample->wi, w) < 1e-6; };
      lt::diagnose(p.cosine > 0 || !is_wi(-2 * p.cosine * p.h - flat), "absolute-cosine", seen);
      lt::diagnose(p.i.z > 0 || !is_wi(p.i), "below-horizon", seen);
      // At a facet that faces up, the mirrored direction goes up, and the opposite one nowhere.
      lt::diagnose(!(is_wi(-p.i) && !ggx_sample(alpha, telling, flat, {0, 0})), "wrong-way", seen);
      lt::diagnose(p.i.z > 0 || !sample, "resample-below-horizon", seen);
      INFO(seen);
      REQUIRE((p.i.z > 0 ? is_wi(p.i) : !sample));
    }
}

TEST_CASE("the density is that of wi, and the weight f times the cosine over it") {
  const Parts p(wo, up[0]);
  const std::optional<Sample> sample = ggx_sample(alpha, telling, wo, up[0]);
  REQUIRE(sample.has_value());
  for (const auto& [tag, formula] : pdf_mistakes)
    lt::diagnose(!is(&Sample::pdf, formula), tag, gave("density", sample->pdf, p.pdf()));
  if (!is_near(sample->pdf, p.pdf())) FAIL(gave("density", sample->pdf, p.pdf()));
  for (const auto& [tag, formula] : weight_mistakes)
    lt::diagnose(!is(&Sample::weight, formula), tag, gave("weight", sample->weight, p.weight()));
  if (!is_near(sample->weight, p.weight()))
    FAIL(gave("weight", sample->weight, p.weight())
         << " There f is " << p.f() << " and the cosine of wi " << p.i.z << '.');
}

TEST_CASE("at 10,000 draws the weight is f times the cosine over the density") {
  const int draws = lt::seeds().size() == 1 ? 10'000 : 500;
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    double largest = 0;
    for (int n = 0; n < draws; ++n) {
      dvec3 o = random.direction();
      o.z = std::abs(o.z) + 0.01;
      o = normalize(o);
      const double x = random.uniform();
      const dvec2 u(x, random.uniform());
      const Parts p(o, u);
      if (std::abs(p.i.z) < 1e-6) continue;  // up or down, by rounding
      const std::optional<Sample> sample = ggx_sample(alpha, telling, o, u);
      INFO(facing(p) << " should give the weight " << p.weight() << " and the density " << p.pdf());
      REQUIRE(sample.has_value() == (p.i.z > 0));
      if (!sample) continue;
      INFO("and gave " << sample->weight << " and " << sample->pdf);
      REQUIRE((is_near(sample->weight / p.weight(), 1) && is_near(sample->pdf / p.pdf(), 1)));
      largest = std::max(largest, sample->weight / telling(p.cosine));
    }
    if (seed == 1)
      lt::measured("the largest of 10,000 weights was " + text_of(largest) +
                   " times what the facet reflects: a bright dot in a picture");
  }
}

TEST_CASE("the mean weight is the share of light that comes back") {
  // Perfect facets of alpha 1, seen from straight above: 1 - ln 2.
  double sum = 0;
  for (int n = 0; n < 10'000; ++n) {
    const dvec2 u((n % 100 + 0.5) / 100, (n / 100 + 0.5) / 100);
    const auto sample = ggx_sample(
        1, [](double) { return 1.0; }, {0, 0, 1}, u);
    sum += sample ? sample->weight : 0;
  }
  CHECK(sum / 10'000 == lt::close_to(1 - std::log(2.0), 1e-3));
}
