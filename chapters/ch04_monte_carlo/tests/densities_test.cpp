#include "ch04_monte_carlo/densities.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "ch04_monte_carlo/density_plots.hpp"
#include "ch04_monte_carlo/mistakes.hpp"
#include "ch04_monte_carlo/rejection.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

constexpr double largest_u = 1 - 0x1p-24;

template <Density P>
KolmogorovSmirnov test_of(const P& density, std::uint64_t seed) {
  Pcg32 random(seed);
  return kolmogorov_smirnov(draw_samples(density, 100'000, random),
                            [&](double x) { return density.cdf(x); });
}

}  // namespace

TEST_CASE("densities: samples have them (Kolmogorov-Smirnov)") {
  for (const double power : {-0.5, 0.0, 1.0, 2.0, 7.0})
    CHECK(test_of(PowerDensity{power, 3}, 1).p_value > 1e-6);
  for (const double rate : {0.1, 1.0, 20.0})
    CHECK(test_of(ExponentialDensity{rate}, 2).p_value > 1e-6);
}

TEST_CASE("densities: integrate to 1, and their integral is the cdf") {
  for (const double power : {0.0, 1.0, 2.0, 3.5}) {
    const PowerDensity density{power, 3};
    const auto pdf = [&](double x) { return density.pdf(x); };
    CHECK(integrate(pdf, 0, 3) == Approx(1).epsilon(1e-8));
    CHECK(integrate(pdf, 0, 1.7) == Approx(density.cdf(1.7)).epsilon(1e-8));
  }
  for (const double rate : {0.5, 2.0}) {
    const ExponentialDensity density{rate};
    const auto pdf = [&](double x) { return density.pdf(x); };
    CHECK(integrate(pdf, 0, 60 / rate) == Approx(1).epsilon(1e-8));  // e^-60 is left out
    CHECK(integrate(pdf, 0, 1.7) == Approx(density.cdf(1.7)).epsilon(1e-8));
  }
}

TEST_CASE("densities: the cdf of a sample is 1 - u: sampling is its inverse") {
  for (double u = 0; u < 1; u += 0x1p-6) {
    CHECK(PowerDensity{2, 5}.cdf(PowerDensity{2, 5}.sample(u)) == Approx(1 - u).epsilon(1e-12));
    CHECK(ExponentialDensity{3}.cdf(ExponentialDensity{3}.sample(u)) ==
          Approx(u).epsilon(1e-12).margin(1e-15));
  }
}

TEST_CASE("densities: moments of samples") {
  // E[x] of 3 x^2 is 3/4, E[x^2] is 3/5; of e^-x they are 1 and 2.
  Pcg32 random(3);
  RunningMean power_1, power_2, exponential_1, exponential_2;
  for (int i = 0; i < 1'000'000; ++i) {
    const double x = PowerDensity{2}.sample(random.next_float());
    const double t = ExponentialDensity{}.sample(random.next_float());
    power_1.add(x);
    power_2.add(x * x);
    exponential_1.add(t);
    exponential_2.add(t * t);
  }
  CHECK(z_test(power_1, 3.0 / 4).agrees());
  CHECK(z_test(power_2, 3.0 / 5).agrees());
  CHECK(z_test(exponential_1, 1).agrees());
  CHECK(z_test(exponential_2, 2).agrees());
}

TEST_CASE("densities: the smallest and largest u give finite samples of positive density") {
  for (const double u : {0.0, largest_u}) {
    const double x = PowerDensity{2, 2}.sample(u);
    CHECK((x > 0 && x <= 2));
    CHECK(PowerDensity{2, 2}.pdf(x) > 0);
    const double t = ExponentialDensity{}.sample(u);
    CHECK((t >= 0 && t < 17));  // -ln 2^-24 = 16.6
    CHECK(ExponentialDensity{}.pdf(t) > 0);
  }
}

TEST_CASE("densities: outside they are 0 and the cdf is 0 or 1") {
  CHECK(PowerDensity{1, 2}.pdf(-0.1) == 0);
  CHECK(PowerDensity{1, 2}.pdf(2.1) == 0);
  CHECK(PowerDensity{1, 2}.cdf(-0.1) == 0);
  CHECK(PowerDensity{1, 2}.cdf(2.1) == 1);
  CHECK(ExponentialDensity{}.pdf(-0.1) == 0);
  CHECK(ExponentialDensity{}.cdf(-0.1) == 0);
}

TEST_CASE("densities, a mistake: the square root for the cube root is found out") {
  Pcg32 random(4);
  std::vector<double> samples;
  for (int i = 0; i < 1000; ++i)
    samples.push_back(mistakes::sample_parabola(random.next_float()));
  const KolmogorovSmirnov test =
      kolmogorov_smirnov(samples, [](double x) { return PowerDensity{2}.cdf(x); });
  // The cdfs x^2 and x^3 are farthest apart at x = 2/3: 4/27.
  CHECK(test.distance == Approx(4.0 / 27).margin(0.06));
  CHECK(test.p_value < 1e-6);
}

TEST_CASE("rejection: x of darts below the semicircle have its distribution") {
  Pcg32 random(5);
  std::vector<double> samples;
  RunningMean darts;
  for (int i = 0; i < 100'000; ++i) {
    const Accepted accepted = sample_by_rejection(semicircle, -1, 1, 1, random);
    samples.push_back(accepted.x);
    darts.add(accepted.darts);
  }
  CHECK(kolmogorov_smirnov(samples, semicircle_cdf).p_value > 1e-6);
  // A share of pi/4 sticks: 4/pi darts a sample, and so pi once more.
  CHECK(z_test(darts, 4 / std::numbers::pi).agrees());
}

TEST_CASE("rejection: a box twice as high costs twice the darts and changes nothing else") {
  Pcg32 random(6);
  RunningMean x, darts;
  for (int i = 0; i < 100'000; ++i) {
    const Accepted accepted = sample_by_rejection([](double t) { return t * t; }, 0, 1, 2, random);
    x.add(accepted.x);
    darts.add(accepted.darts);
  }
  CHECK(z_test(x, 3.0 / 4).agrees());
  CHECK(z_test(darts, 6).agrees());  // a box of area 2 around an area of 1/3
}

TEST_CASE("rejection: the semicircle's cdf is its integral") {
  CHECK(semicircle_cdf(-1) == Approx(0).margin(1e-15));
  CHECK(semicircle_cdf(1) == Approx(1));
  const double part = integrate(semicircle, -1, 0.3, 1e-8);
  CHECK(semicircle_cdf(0.3) == Approx(part * 2 / std::numbers::pi).epsilon(1e-6));
}
