#include "ch06_importance_sampling/mistakes.hpp"

#include <numbers>

#include "ch05_rendering_equation/furnace.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "ch06_importance_sampling/samplers.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const vec3 up(0, 0, 1);

// The naive test: what a furnace of albedo 0.5 shows after one event, which should be 1.5.
template <Scattering Model>
RunningMean naive_test(const Model& bsdf_at) {
  static const HollowSphere furnace{matt(Rgb(0.5f), Rgb(1.0f))};
  return many({vec3(0.0f), up}, 100'000, [&](const Ray& ray, Pcg32& random) {
    return radiance_recursive(furnace, bsdf_at, ray, 1, random);
  });
}

std::string chi_square_complaint(const std::string& name, const std::string& wrong) {
  Pcg32 random(1);
  return report_on(sampler_named(name, wrong), 100'000, DirectionBins(), random).complaint;
}

}  // namespace

TEST_CASE("mistakes: the old density makes every surface give back a third too much") {
  // Weight 2 a cos, and E[cos] = 2/3.
  const RunningMean seen = naive_test(mistakes::old_density_at);
  CHECK(z_test(seen, 1 + 0.5 * 4 / 3).agrees());
  CHECK_FALSE(z_test(seen, 1.5).agrees(0.01));
  CHECK_FALSE(chi_square_complaint("cosine", "density").empty());
}

TEST_CASE("mistakes: errors that cancel pass the naive test with no error at all") {
  const RunningMean seen = naive_test(mistakes::both_uniform_at);
  CHECK(seen.mean() == 1.5);
  CHECK(seen.variance() == 0);
}

TEST_CASE("mistakes: errors that cancel pass the triple and both integrals as well") {
  const mistakes::BothUniform wrong{Rgb(0.5f)};
  Pcg32 random(1);
  CHECK(triple_complaint(wrong, up, 10'000, random) == "");
  CHECK(integrate_directions([&](vec3 wi) { return wrong.pdf(up, wi); }) == Approx(1));
  CHECK(integrate_directions([&](vec3 wi) { return wrong.eval(up, wi).g * std::abs(wi.z); }) ==
        Approx(0.5).epsilon(1e-5));
}

TEST_CASE("mistakes: errors that cancel fail the chi-square and the moments of their density") {
  CHECK_FALSE(chi_square_complaint("cosine", "both").empty());
  Pcg32 random(2);
  RunningMean z;
  for (int i = 0; i < 100'000; ++i)
    z.add(mistakes::BothUniform{Rgb(0.5f)}.sample(up, random.next_vec3())->wi.z);
  // By the density that it says, 1 / (2 pi), E[z] would be 1/2.
  CHECK(z_test(z, 2.0 / 3).agrees());
  CHECK_FALSE(z_test(z, 1.0 / 2).agrees(0.01));
}

TEST_CASE("mistakes: the growth of chi-square is n times what the densities differ") {
  // Cosine's directions against the uniform density: n sum (p - q)^2 / q over rows of z, where q is
  // 1/12 and p is (2i + 1) / 144; the columns share both evenly.
  double growth = 0;
  for (int i = 0; i < 12; ++i)
    growth += std::pow((2 * i + 1) / 144.0 - 1.0 / 12, 2) * 12;
  for (const int n : {100'000, 400'000}) {
    Pcg32 random(3);
    const auto report =
        report_on(sampler_named("cosine", "both"), n, DirectionBins(24, 32), random);
    CHECK(report.chi_square.statistic == Approx(n * growth).epsilon(0.05));
  }
}

TEST_CASE("mistakes: without the root a furnace sees nothing and chi-square everything") {
  CHECK(naive_test(mistakes::without_root_at).mean() == 1.5);
  CHECK_FALSE(chi_square_complaint("cosine", "root").empty());
  // r = u instead of sqrt(u): E[z] is the integral of sqrt(1 - u^2), a quarter of the circle.
  Pcg32 random(4);
  RunningMean z;
  for (int i = 0; i < 100'000; ++i)
    z.add(mistakes::cosine_hemisphere_without_root(random.next_vec2()).z);
  CHECK(z_test(z, std::numbers::pi / 4).agrees());
}

TEST_CASE("mistakes: chi-square finds nothing where nothing is wrong") {
  CHECK(chi_square_complaint("uniform", "none") == "");
  CHECK(chi_square_complaint("cosine", "none") == "");
}
