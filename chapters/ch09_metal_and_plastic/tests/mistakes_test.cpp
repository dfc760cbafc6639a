// What each mistake does, in numbers; which test sees it, and which does not.
#include "ch09_metal_and_plastic/mistakes.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch09_metal_and_plastic/sampler_plots.hpp"
#include "ch09_metal_and_plastic/tests/grid.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;
namespace m = lt::mistakes;

namespace {

m::ByAllNormals<PerfectMirror> mirrors(float alpha) {
  return {{alpha}, {}};
}

template <class AnyBsdf>
RunningMean weights(const AnyBsdf& bsdf, float mu, int count = 200'000) {
  RunningMean mean;
  for (const double weight : weights_of(bsdf, slanting_at(mu), count, 1))
    mean.add(weight);
  return mean;
}

template <class AnyBsdf>
std::string triple(const AnyBsdf& bsdf, float mu) {
  Pcg32 random(2);
  return triple_complaint(bsdf, slanting_at(mu), 20'000, random);
}

template <class AnyBsdf>
double p_value(const AnyBsdf& bsdf, float mu) {
  return chi_square_of(bsdf, slanting_at(mu), 100'000, 3).p_value;
}

}  // namespace

TEST_CASE("mistakes: without the Jacobian light is divided by 4 cos, and the triple is content") {
  // Straight from above a smooth mirror's facets have cosine 1: a quarter is left.
  const m::JacobianForgotten<PerfectMirror> wrong{mirrors(0.01f)};
  CHECK(weights(wrong, 1.0f).mean() == close_to(0.25, 1e-3));
  // At cosine 0.1 it is 1 / 0.4: more comes out than went in.
  CHECK(weights(wrong, 0.1f).mean() == close_to(2.5, 0.05));
  const m::JacobianForgotten<PerfectMirror> rough{mirrors(0.3f)};
  CHECK(triple(rough, 0.5f) == "");
  CHECK(p_value(rough, 0.5f) == 0.0);
}

TEST_CASE("mistakes: n.o for h.o is nearly right on smooth surfaces, and chi-square tells") {
  CHECK(weights(m::JacobianAtSurface<PerfectMirror>{mirrors(0.01f)}, 0.9f).mean() ==
        close_to(1.0, 1e-3));
  const m::JacobianAtSurface<PerfectMirror> rough{mirrors(0.3f)};
  CHECK(weights(rough, 0.1f).mean() < 0.35 * weights(mirrors(0.3f), 0.1f).mean());
  CHECK(triple(rough, 0.5f) == "");
  CHECK(p_value(rough, 0.5f) == 0.0);
}

TEST_CASE("mistakes: drawn again, the mean is divided by the share that is accepted") {
  for (const float mu : {0.5f, 0.1f}) {
    const auto right = mirrors(0.3f);
    RunningMean accepted;
    for (const double weight : weights_of(right, slanting_at(mu), 200'000, 4))
      accepted.add(weight > 0);
    const double expected = weights(right, mu).mean() / accepted.mean();
    const m::Redrawn<PerfectMirror> wrong{right};
    CHECK(weights(wrong, mu).mean() == Approx(expected).epsilon(0.02));
    CHECK(weights(wrong, mu).mean() > 1.02);  // more than there was
    CHECK(triple(wrong, mu) == "");           // each sample by itself is right
    CHECK(p_value(wrong, mu) == 0.0);
  }
}

TEST_CASE("mistakes: paid twice, directions are right and the triple complains of the weight") {
  const m::PaidTwice<PerfectMirror> wrong{mirrors(0.3f)};
  CHECK(p_value(wrong, 0.5f) > 1e-6);
  CHECK(triple(wrong, 0.5f).find("but eval |cos| / pdf is") != std::string::npos);
}

TEST_CASE("mistakes: Fresnel at the surface is not the same both ways, nothing else notices") {
  // The thesis' gold, from 10 to 80 degrees and back: F at the surface is 0.890914 at 10 and
  // 0.91528 at 80 degrees, at the facet 0.88839 both times.
  const ConductorFresnel gold_by_thesis{{Rgb(0.277f), Rgb(2.92f)}};
  const m::FresnelAtSurface<ConductorFresnel> wrong{{{0.5f}, gold_by_thesis}};
  const vec3 steep(std::sin(radians(10)), 0.0f, std::cos(radians(10)));
  const vec3 flat(-std::sin(radians(80)), 0.0f, std::cos(radians(80)));
  const float ratio = wrong.eval(steep, flat).g / wrong.eval(flat, steep).g;
  CHECK(ratio == close_to(0.89091f / 0.91528f, 1e-4));
  CHECK(triple(wrong, 0.5f) == "");
  CHECK(p_value(wrong, 0.5f) > 1e-6);
  CHECK(weights(wrong, 0.5f).mean() < 1);
}

TEST_CASE("mistakes: Fresnel at the surface, for glass, is wrong ninefold") {
  // Index 1.5: 0.0400 at 10 degrees against 0.3877 at 80.
  const m::FresnelAtSurface<DielectricFresnel> wrong{{{0.5f}, {1.0f, 1.5f}}};
  const vec3 steep(std::sin(radians(10)), 0.0f, std::cos(radians(10)));
  const vec3 flat(-std::sin(radians(80)), 0.0f, std::cos(radians(80)));
  CHECK(wrong.eval(flat, steep).g / wrong.eval(steep, flat).g == Approx(9.7).epsilon(0.01));
}

TEST_CASE("mistakes: the printed reflection is not unit where facets show their back") {
  // |w|^2 = 1 + 8 c^2; for c = -0.174, -0.766, -0.866: 1.114, 2.386, 2.646.
  const std::pair<float, double> rows[] = {{-0.1736f, 1.114}, {-0.7660f, 2.386}, {-0.8660f, 2.646}};
  for (const auto& [c, expected] : rows) {
    const vec3 wo(std::sqrt(1 - c * c), 0.0f, c);
    CHECK(length(m::reflected_as_printed(wo, {0, 0, 1})) == close_to(expected, 1e-3));
  }
  const vec3 front = slanting_at(0.3f);
  CHECK(m::reflected_as_printed(front, {0, 0, 1}) == reflected(front, {0, 0, 1}));
}

TEST_CASE("mistakes: with backs reflecting, more comes out than went in, at flat angles only") {
  const m::AbsoluteValue<PerfectMirror> wrong{mirrors(0.3f)};
  CHECK(weights(wrong, 0.9f).mean() == Approx(weights(mirrors(0.3f), 0.9f).mean()).epsilon(1e-6));
  CHECK(weights(wrong, 0.1f).mean() > 1.1);
  CHECK(p_value(wrong, 0.1f) == 0.0);
}

TEST_CASE("mistakes: the angles by their printed names follow no density that anybody claimed") {
  CHECK(p_value(m::AnglesExchanged<PerfectMirror>{mirrors(0.3f)}, 0.5f) == 0.0);
  CHECK(weights(m::AnglesExchanged<PerfectMirror>{mirrors(0.1f)}, 0.9f).mean() < 0.5);
}
