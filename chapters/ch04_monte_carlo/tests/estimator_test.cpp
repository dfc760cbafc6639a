#include "ch04_monte_carlo/estimator.hpp"

#include <cmath>
#include <numbers>

#include "ch04_monte_carlo/densities.hpp"
#include "ch04_monte_carlo/integrals.hpp"
#include "ch04_monte_carlo/mistakes.hpp"
#include "ch04_monte_carlo/streams.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

TEST_CASE("estimator: known integrals are what quadrature finds") {
  // To 1e-6, for the edge: an adaptive rule does not like jumps.
  for (const KnownIntegral& integral : known_integrals())
    CHECK(integrate(integral.f, integral.a, integral.b) == Approx(integral.exact).epsilon(1e-6));
}

TEST_CASE("estimator: finds the three integrals within its error") {
  Pcg32 random(1);
  for (const KnownIntegral& integral : known_integrals()) {
    const RunningMean samples =
        estimate_uniform(integral.f, integral.a, integral.b, 1'000'000, random);
    INFO(integral.name << ": " << samples.mean() << " +- " << samples.standard_error());
    CHECK(samples.count() == 1'000'000);
    CHECK(z_test(samples, integral.exact).agrees());
    CHECK(samples.mean() == Approx(integral.exact).epsilon(0.01));
  }
}

TEST_CASE("estimator: its variance is (b - a) int f^2 - (int f)^2") {
  // pi * pi / 2 - 4 for the sine. Relative error of a variance: root of (kurtosis - 1) / n, less
  // than 0.2 % here.
  Pcg32 random(2);
  const KnownIntegral integral = sine();
  const RunningMean samples =
      estimate_uniform(integral.f, integral.a, integral.b, 1'000'000, random);
  CHECK(samples.variance() == Approx(std::numbers::pi * std::numbers::pi / 2 - 4).epsilon(0.01));
}

TEST_CASE("estimator: ends in the wrong order turn the sign, as in the integral") {
  Pcg32 random(3);
  const auto square = parabola().f;
  const RunningMean samples = estimate_uniform(square, 2, 0, 1'000'000, random);
  CHECK(z_test(samples, -8.0 / 3).agrees());
}

TEST_CASE("importance: any density that covers the integrand gives the same mean") {
  const auto square = parabola().f;
  for (const double power : {0.0, 0.5, 1.0, 2.5}) {
    Pcg32 random(4);
    const RunningMean samples =
        estimate_importance(square, PowerDensity{power, 2}, 1'000'000, random);
    INFO("p ~ x^" << power << ": " << samples.mean());
    CHECK(z_test(samples, 8.0 / 3).agrees());
    CHECK(samples.mean() == Approx(8.0 / 3).epsilon(0.01));
  }
}

TEST_CASE("importance: variances are int f^2 / p - (int f)^2") {
  // f = x^2 over [0, 2]. p = 1/2: 2 * 32/5 - 64/9 = 256/45. p = x/2: int 2 x^3 = 8; 8 - 64/9 = 8/9.
  const auto square = parabola().f;
  Pcg32 random(5);
  const auto variance = [&](double power) {
    return estimate_importance(square, PowerDensity{power, 2}, 1'000'000, random).variance();
  };
  CHECK(variance(0) == Approx(256.0 / 45).epsilon(0.01));
  CHECK(variance(1) == Approx(8.0 / 9).epsilon(0.01));
}

TEST_CASE("importance: a density in proportion to the integrand has no error at all") {
  Pcg32 random(6);
  const RunningMean samples = estimate_importance(parabola().f, PowerDensity{2, 2}, 1000, random);
  CHECK(samples.mean() == Approx(8.0 / 3).epsilon(1e-14));
  CHECK(samples.variance() < 1e-28);
}

TEST_CASE("importance, a mistake: the printed factor b - a doubles the integral from 0 to 2") {
  // Thesis eq. 12: E[|b - a| f / p] = |b - a| int f = 2 * 8/3.
  Pcg32 random(7);
  const RunningMean printed =
      mistakes::estimate_importance(parabola().f, PowerDensity{1, 2}, 0, 2, 1'000'000, random);
  CHECK(z_test(printed, 16.0 / 3).agrees());
  CHECK_FALSE(z_test(printed, 8.0 / 3).agrees(0.01));
}

TEST_CASE("importance, a mistake: a density that is 0 where the integrand is not loses that part") {
  // Samples from [0, 1] for the integral over [0, 2]: they find 1/3 and are sure of it.
  Pcg32 random(8);
  const RunningMean samples =
      estimate_importance(parabola().f, PowerDensity{1, 1}, 1'000'000, random);
  CHECK(z_test(samples, 1.0 / 3).agrees());
  CHECK_FALSE(z_test(samples, 8.0 / 3).agrees(0.01));
}

TEST_CASE("strata: one point in each part, and the mean of estimates is the integral") {
  int part = 0;
  bool is_in_part = true;
  const auto probe = [&](double x) {
    is_in_part = is_in_part && x >= 3 + part * 0.25 && x < 3 + (part + 1) * 0.25;
    ++part;
    return 0.0;
  };
  Pcg32 random(9);
  CHECK(estimate_stratified(probe, 3, 5, 8, random) == 0);
  CHECK(part == 8);
  CHECK(is_in_part);

  for (const KnownIntegral& integral : known_integrals()) {
    RunningMean estimates;
    for (int repeat = 0; repeat < 10'000; ++repeat)
      estimates.add(estimate_stratified(integral.f, integral.a, integral.b, 10, random));
    CHECK(z_test(estimates, integral.exact).agrees());
  }
}
