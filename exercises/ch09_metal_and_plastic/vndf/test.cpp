#include "api.hpp"
#include "formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace exercise {

double ggx_d(double a, glm::dvec3 h) {
  const double bracket = h.x * h.x + h.y * h.y + a * a * h.z * h.z;
  return a * a / (std::numbers::pi * bracket * bracket);
}
namespace {
double lambda(double a, glm::dvec3 w) {
  return (std::hypot(1, a * std::hypot(w.x, w.y) / w.z) - 1) / 2;
}
}  // namespace
double smith_g1(double a, glm::dvec3 w) {
  return 1 / (1 + lambda(a, w));
}
double smith_g2(double a, glm::dvec3 wo, glm::dvec3 wi) {
  return wi.z > 0 ? 1 / (1 + lambda(a, wo) + lambda(a, wi)) : 0;
}

}  // namespace exercise

namespace {

using namespace oracle;
using lt::text_of, lt::text_of_u;

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6 * std::max(1.0, std::abs(b));  // false for NaN
}
// Up to rounding, up and the viewer.
bool faces_both(dvec3 wo, dvec3 h) {
  return h.z > -1e-9 && dot(wo, h) > -1e-9;
}
bool is_finite(dvec3 v) {
  return std::isfinite(v.x + v.y + v.z);
}
std::string gave(dvec3 wo, dvec2 u) {
  return "sample_visible(0.4, " + text_of(wo) + ", (" + text_of_u(u.x) + ", " + text_of_u(u.y) +
         ")) gave " + text_of(sample_visible(alpha, wo, u));
}
std::string gave(const std::string& name, dvec3 a, dvec3 b, double value, double right) {
  return name + "(0.4, " + text_of(a) + ", " + text_of(b) + ") gave " + text_of(value) +
         " and should give " + text_of(right) + '.';
}

std::vector<dvec3> drawn(double a, dvec3 wo, std::uint64_t seed, std::size_t count) {
  lt::TestRandom random(seed);
  std::vector<dvec3> normals(count);
  for (dvec3& h : normals) {
    const double x = random.uniform();
    h = sample_visible(a, wo, {x, random.uniform()});
  }
  return normals;
}
// Another mistake is named elsewhere.
bool is_right_elsewhere() {
  return fits(counts_of(drawn(alpha, low, 1, 20'000)), expected_of(alpha, low, 20'000).counts);
}
// What is seen of them all at once.
std::string summary(const std::vector<dvec3>& normals, dvec3 wo, dvec3 right) {
  dvec3 mean(0);
  int down = 0, backs = 0;
  for (const dvec3& h : normals) {
    mean += h / static_cast<double>(normals.size());
    down += h.z < -1e-9;
    backs += dot(wo, h) < -1e-9;
  }
  const auto rounded = [](dvec3 v) { return text_of(round(v * 1000.0) / 1000.0); };
  return "Normals for wo = " + text_of(wo) + " have the mean " + rounded(mean) +
         " and should have " + rounded(right) + "; of " + std::to_string(normals.size()) + ", " +
         std::to_string(down) + " face down and " + std::to_string(backs) + " show wo their back.";
}

}  // namespace

TEST_CASE("every normal is a number and 1 long") {
  const std::array one{1 - 0x1p-53, 0.0, 0.03, 0.2, 0.25, 0.4, 0.6, 0.75, 0.97};
  for (const dvec3 wo : {low, flat, above})
    for (const double x : one)
      for (const double y : one) {
        const dvec3 h = sample_visible(alpha, wo, {x, y});
        const std::string seen = gave(wo, {x, y});
        lt::diagnose(is_finite(h) || wo != above || !is_right_elsewhere(), "nan-from-above",
                     seen + '.');
        INFO(seen);
        REQUIRE(is_finite(h));
        lt::diagnose(std::abs(length(h) - 1) < 1e-6, "not-unit",
                     seen + ", which is " + text_of(length(h)) + " long and should be 1.");
      }
  for (const auto& [a, b] :
       {std::pair(dvec2(0.3, 0.1), dvec2(0.3, 0.6)), std::pair(dvec2(0.1, 0.3), dvec2(0.6, 0.3))})
    lt::diagnose(distance(sample_visible(alpha, low, a), sample_visible(alpha, low, b)) > 1e-6,
                 "same-number-twice", gave(low, a) + ", and " + gave(low, b) + '.');
}

TEST_CASE("facets come as often as wo sees them") {
  const std::vector<dvec3> normals = drawn(alpha, low, 1, 100'000);
  const Expected expected = expected_of(alpha, low, 100'000);
  const std::string seen = summary(normals, low, expected.mean);
  if (!fits(counts_of(normals), expected.counts)) {
    lt::diagnose(!std::ranges::all_of(normals, [](dvec3 h) { return dot(low, h) < 0; }),
                 "turned-away", seen);
    const std::vector<double> counts = counts_of({normals.begin(), normals.begin() + 20'000});
    for (const auto& [tag, sampler] : mistakes)
      lt::diagnose(!fits(counts, expected_of(sampler, 20'000)), tag, seen);
    FAIL(seen << " By chi-square, 256 cells are filled otherwise than they should.");
  }
  INFO(seen);
  REQUIRE(std::ranges::all_of(normals, [](dvec3 h) { return faces_both(low, h); }));
}

TEST_CASE("visible_pdf is what one sees of such facets, out of what one sees of the surface") {
  const auto is = [](PdfMistake formula) {
    return std::ranges::all_of(seen_facets, [&](const auto& f) {
      return is_near(visible_pdf(alpha, f.first, f.second), formula({f.first, f.second}));
    });
  };
  const auto text = [](dvec3 wo, dvec3 h) {
    return gave("visible_pdf", wo, h, visible_pdf(alpha, wo, h), Facet{wo, h}.pdf());
  };
  for (const auto& [tag, formula] : pdf_mistakes)
    lt::diagnose(!is(formula), tag, text(low, seen_facets[0].second));
  for (const auto& [wo, h] : seen_facets) {
    INFO(text(wo, h));
    REQUIRE(is_near(visible_pdf(alpha, wo, h), Facet{wo, h}.pdf()));
  }
  const dvec3 back{-0.8, 0.36, 0.48};
  lt::diagnose(visible_pdf(alpha, flat, back) == 0, "back-has-density", text(flat, back));
}

TEST_CASE("visible_weight is what is lit of what is seen, and never above 1") {
  const auto is = [](WeightMistake formula) {
    return std::ranges::all_of(lit_pairs, [&](const auto& p) {
      return is_near(visible_weight(alpha, p.first, p.second), formula(p.first, p.second));
    });
  };
  const auto text = [](dvec3 wo, dvec3 wi) {
    return gave("visible_weight", wo, wi, visible_weight(alpha, wo, wi), right_weight(wo, wi));
  };
  for (const auto& [tag, formula] : weight_mistakes)
    lt::diagnose(!is(formula), tag, text(low, lit_pairs[0].second));
  for (const auto& [wo, wi] : lit_pairs)
    for (const dvec3 side : {wi, wi * dvec3(1, 1, -1)}) {
      INFO(text(wo, side));
      REQUIRE(is_near(visible_weight(alpha, wo, side), right_weight(wo, side)));
    }
}

TEST_CASE("at random places: all faces wo, and density and weight agree") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (int i = 0; i < 200; ++i) {
      const double a = random.uniform(0.05, 1);
      dvec3 wo = random.direction();
      wo.z = std::abs(wo.z) + 1e-3;
      wo = normalize(wo);
      const double x = random.uniform();
      const dvec3 h = sample_visible(a, wo, {x, random.uniform()});
      const dvec3 wi = 2 * dot(wo, h) * h - wo;
      INFO("sample_visible(" << text_of(a) << ", " << text_of(wo) << ", ...) gave " << text_of(h));
      REQUIRE(faces_both(wo, h));
      const Facet f{wo, h, a};
      const double pdf = visible_pdf(a, wo, h), weight = visible_weight(a, wo, wi);
      INFO("Its density gave " << pdf << " and should give " << f.pdf());
      REQUIRE(is_near(pdf / f.pdf(), 1));
      // f cos / p(wi), where p(wi) is the density of h over 4 (wo . h).
      const double right = f.d * smith_g2(a, wo, wi) * f.cosine / (wo.z * f.pdf());
      INFO("The weight gave " << weight << " and should give " << right);
      REQUIRE(is_near(weight, right));
      REQUIRE(weight <= 1 + 1e-9);
    }
  }
}

TEST_CASE("normals are as dense as the density says: chi-square from three places") {
  for (const auto& [a, wo] : {std::pair(alpha, low), std::pair(0.2, flat), std::pair(1.0, above)}) {
    const std::size_t count = lt::seeds().size() == 1 ? 100'000 : 5'000;
    const Expected expected = expected_of(a, wo, static_cast<double>(count));
    for (const auto seed : lt::seeds()) {
      const std::vector<dvec3> normals = drawn(a, wo, seed, count);
      INFO("alpha " << a << ". " << summary(normals, wo, expected.mean));
      REQUIRE(fits(counts_of(normals), expected.counts));
    }
  }
}

TEST_CASE("the mean weight is the share of light that comes back, with little noise") {
  // Perfect facets of alpha 1, seen from straight above: 1 - ln 2.
  double sum = 0;
  for (int n = 0; n < 10'000; ++n) {
    const dvec3 h = sample_visible(1, above, {(n % 100 + 0.5) / 100, (n / 100 + 0.5) / 100});
    sum += visible_weight(1, above, 2 * h.z * h - above);
  }
  CHECK(sum / 10'000 == lt::close_to(1 - std::log(2.0), 1e-3));

  // At alpha 0.4 and the cosine 0.2, the weights of exercise 09.2 have a variance of 1.42, those
  // of visible facets one of 0.0814 (both by quadrature over the two numbers).
  const dvec3 wo(std::sqrt(0.96), 0, 0.2);
  lt::RunningMean weights;
  for (const dvec3& h : drawn(alpha, wo, 1, 20'000))
    weights.add(visible_weight(alpha, wo, 2 * dot(wo, h) * h - wo));
  CHECK(1.42 / weights.variance() > 8);
  lt::measured("at alpha 0.4 and the cosine 0.2, one sample is worth " +
               text_of(1.42 / weights.variance(), 3) + " of those that take any facet");
}
