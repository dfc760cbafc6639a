#include "ch04_monte_carlo/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ch04_monte_carlo/error_bar_plots.hpp"
#include "ch04_monte_carlo/mistakes.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

TEST_CASE("interval: mean and 1.96 standard errors to both sides") {
  RunningMean samples;
  for (const double value : {4, 7, 13, 16})  // mean 10, variance 30
    samples.add(value);
  const Interval interval = confidence_interval(samples);
  CHECK(interval.low == Approx(10 - 1.959964 * std::sqrt(30.0 / 4)));
  CHECK(interval.high == Approx(10 + 1.959964 * std::sqrt(30.0 / 4)));
  CHECK(interval.holds(10));
  CHECK_FALSE(interval.holds(16));
  CHECK(confidence_interval(samples, 3).holds(16));
}

TEST_CASE("interval: 1.96 standard errors leave out one normal number in twenty") {
  // P(|Z| > z) is the upper tail of a chi-square with one degree of freedom at z^2.
  CHECK(chi_square_tail(standard_errors_95 * standard_errors_95, 1) == Approx(0.05).epsilon(1e-6));
}

TEST_CASE("interval: about 380 of 400 hold the true value") {
  // Binomial: 400 * 0.95 = 380, standard deviation 4.36. 353 is 6.2 of them below; all 400 would
  // have a probability of 0.95^400 = 1.2e-9.
  for (const KnownIntegral& integral : known_integrals()) {
    const std::vector<Interval> intervals = repeated_intervals(integral, 400, 1000, 1);
    const auto count =
        std::count_if(intervals.begin(), intervals.end(),
                      [&](const Interval& interval) { return interval.holds(integral.exact); });
    INFO(integral.name);
    CHECK(count >= 353);
    CHECK(count <= 399);
  }
}

TEST_CASE("interval: 6 standard errors, the course's limit, hold it always") {
  for (int repeat = 0; repeat < 2000; ++repeat) {
    Pcg32 random = stream_for(2, repeat, 0, 0);
    REQUIRE(confidence_interval(estimate_uniform(sine().f, sine().a, sine().b, 1000, random), 6)
                .holds(2));
  }
}

TEST_CASE("interval, a mistake: where the squares have no mean, error bars lie") {
  // (1 - x)^(-3/4) over [0, 1] is 4, but the integral of its square is infinite. x is never 1.
  int count = 0;
  for (int repeat = 0; repeat < 400; ++repeat) {
    Pcg32 random = stream_for(3, repeat, 0, 0);
    const auto f = [](double x) { return std::pow(1 - x, -0.75); };
    count += confidence_interval(estimate_uniform(f, 0, 1, 1000, random)).holds(4);
  }
  INFO(count);
  CHECK(count < 353);
}

TEST_CASE("running mean: values near a billion keep their variance, the naive formula loses it") {
  const mistakes::Variances found = mistakes::variances_at_offset(1e9, 1);
  // A uniform multiple of 1/1024: variance (1 - 2^-20) / 12, of a thousand to some percent.
  CHECK(found.exact == Approx(1.0 / 12).epsilon(0.2));
  CHECK(found.welford == Approx(found.exact).epsilon(1e-6));
  CHECK(std::abs(found.naive / found.exact - 1) > 1);
}

TEST_CASE("pi: darts find it within their error") {
  Pcg32 random(1);
  const RunningMean samples = estimate_pi(throw_darts(1'000'000, random));
  CHECK(z_test(samples, std::numbers::pi).agrees());
  // 0 or 4 with probability pi/4: variance pi (4 - pi).
  CHECK(samples.variance() == Approx(std::numbers::pi * (4 - std::numbers::pi)).epsilon(0.01));
}

TEST_CASE("p-values: uniform for the right sampler, near 0 for the wrong one") {
  const auto right = [](double u) { return PowerDensity{2}.sample(u); };
  const auto uniform = [](double x) { return x; };
  CHECK(kolmogorov_smirnov(p_values(right, 400, 500, 1), uniform).p_value > 1e-6);
  CHECK(p_values(mistakes::sample_parabola, 200, 500, 1).back() < 1e-3);
}
