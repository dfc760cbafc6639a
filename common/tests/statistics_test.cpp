#include "common/testkit/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/testkit/catch.hpp"
#include "common/testkit/exercise.hpp"

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

double uniform_cdf(double x) {
  return std::clamp(x, 0.0, 1.0);
}

// n samples, evenly spread over [0, 1] and then moved so that their distance is `distance`.
std::vector<double> samples_at_distance(int n, double distance) {
  std::vector<double> samples;
  for (int i = 0; i < n; ++i)
    samples.push_back((i + 0.5) / n + distance - 0.5 / n);
  return samples;
}

}  // namespace

TEST_CASE("chi-square tail: the printed tables") {
  // NIST/SEMATECH e-Handbook of Statistical Methods, table 1.3.6.7.4.
  CHECK(lt::chi_square_tail(3.841459, 1) == Approx(0.05).epsilon(1e-6));
  CHECK(lt::chi_square_tail(6.634897, 1) == Approx(0.01).epsilon(1e-6));
  CHECK(lt::chi_square_tail(11.070, 5) == Approx(0.05).epsilon(1e-3));
  CHECK(lt::chi_square_tail(18.30704, 10) == Approx(0.05).epsilon(1e-6));
  CHECK(lt::chi_square_tail(2.558, 10) == Approx(0.99).epsilon(1e-3));
  CHECK(lt::chi_square_tail(29.588, 10) == Approx(0.001).epsilon(1e-3));
  CHECK(lt::chi_square_tail(124.342, 100) == Approx(0.05).epsilon(1e-3));
  CHECK(lt::chi_square_tail(77.929, 100) == Approx(0.95).epsilon(1e-3));
}

TEST_CASE("chi-square tail: closed forms, far out too") {
  for (const double x : {1e-6, 0.1, 1.0, 2.9, 3.0, 5.0, 30.0, 200.0, 1000.0}) {
    // One degree is a squared normal, two are exponential, four follow by parts.
    CHECK(lt::chi_square_tail(x, 1) == Approx(std::erfc(std::sqrt(x / 2))).epsilon(1e-10));
    CHECK(lt::chi_square_tail(x, 2) == Approx(std::exp(-x / 2)).epsilon(1e-10));
    CHECK(lt::chi_square_tail(x, 4) == Approx(std::exp(-x / 2) * (1 + x / 2)).epsilon(1e-10));
  }
  CHECK(lt::chi_square_tail(0, 3) == 1);
  CHECK(lt::chi_square_tail(-1, 3) == 1);
  CHECK(lt::chi_square_tail(infinite, 3) == 0);
  CHECK(lt::chi_square_tail(not_a_number, 3) == 0);
}

TEST_CASE("chi-square tail: normal quantiles, squared") {
  // P(|Z| > z) = 0.05, 0.01 and, at the course's limit of 6, 1.973e-9: once in 5e8 draws.
  CHECK(lt::chi_square_tail(std::pow(1.959963985, 2), 1) == Approx(0.05).epsilon(1e-8));
  CHECK(lt::chi_square_tail(std::pow(2.575829304, 2), 1) == Approx(0.01).epsilon(1e-8));
  CHECK(lt::chi_square_tail(36, 1) == Approx(1.973e-9).epsilon(1e-3));
}

TEST_CASE("chi-square tail: many degrees of freedom") {
  // Wilson and Hilferty (1931): (x / n)^(1/3) is nearly normal. 1.644854 is the 95 % quantile.
  for (const int n : {1000, 10'000, 100'000}) {
    const double v = 2.0 / (9.0 * n);
    const double x = n * std::pow(1 - v + 1.644854 * std::sqrt(v), 3);
    CHECK(lt::chi_square_tail(x, n) == Approx(0.05).epsilon(1e-3));
    const double y = n * std::pow(1 - v - 1.644854 * std::sqrt(v), 3);
    CHECK(lt::chi_square_tail(y, n) == Approx(0.95).epsilon(1e-3));
  }
}

TEST_CASE("running mean: a large offset does not drown the variance") {
  // 4, 7, 13, 16: mean 10, squares of the deviations 36 + 9 + 9 + 36 = 90, variance 90 / 3.
  for (const double offset : {0.0, 1e9, -1e9}) {
    lt::RunningMean sample;
    for (const double value : {4, 7, 13, 16})
      sample.add(offset + value);
    CHECK(sample.count() == 4);
    CHECK(sample.mean() == Approx(offset + 10).epsilon(1e-15));
    CHECK(sample.variance() == Approx(30).epsilon(1e-6));
    CHECK(sample.standard_error() == Approx(std::sqrt(30.0 / 4)).epsilon(1e-6));
  }
}

TEST_CASE("running mean: nothing and one sample have no variance") {
  lt::RunningMean sample;
  CHECK(sample.mean() == 0);
  CHECK(sample.standard_error() == 0);
  sample.add(5);
  CHECK(sample.mean() == 5);
  CHECK(sample.variance() == 0);
}

TEST_CASE("running mean: the standard error is as large as the errors are") {
  // z of 100 uniform samples is Student's t with 99 degrees, nearly: E[z^2] = 99 / 97.
  lt::TestRandom random(5);
  lt::RunningMean z_squared;
  for (int repeat = 0; repeat < 5000; ++repeat) {
    lt::RunningMean sample;
    for (int i = 0; i < 100; ++i)
      sample.add(random.uniform());
    z_squared.add(std::pow(lt::z_test(sample, 0.5).z, 2));
  }
  CHECK(lt::z_test(z_squared, 99.0 / 97.0).agrees());
}

TEST_CASE("z-test: rejects only what is both certain and large enough to matter") {
  const lt::ZTest certain_but_small = lt::z_test(1.005, 0.0001, 1);
  CHECK(certain_but_small.z == Approx(50));
  CHECK(certain_but_small.effect == Approx(0.005));
  CHECK(certain_but_small.agrees(0.01));
  CHECK_FALSE(certain_but_small.agrees());

  const lt::ZTest large_but_uncertain = lt::z_test(1.5, 0.1, 1);
  CHECK(large_but_uncertain.z == Approx(5));
  CHECK(large_but_uncertain.agrees());

  const lt::ZTest wrong = lt::z_test(-2.2, 0.01, -2);
  CHECK(wrong.z == Approx(-20));
  CHECK(wrong.effect == Approx(-0.1));
  CHECK_FALSE(wrong.agrees(0.01));
  CHECK(wrong.agrees(0.11));
}

TEST_CASE("z-test: expected zero, no variance, and NaN") {
  CHECK(lt::z_test(0.5, 0.01, 0).effect == Approx(0.5));
  CHECK(lt::z_test(2, 0, 2).z == 0);
  CHECK(lt::z_test(2, 0, 2).agrees());
  CHECK(lt::z_test(3, 0, 2).z == infinite);
  CHECK(lt::z_test(1, 0, 2).z == -infinite);
  CHECK_FALSE(lt::z_test(3, 0, 2).agrees(0.01));
  CHECK_FALSE(lt::z_test(not_a_number, 0.1, 2).agrees(0.01));
  CHECK_FALSE(lt::z_test(2, not_a_number, 2).agrees(0.01));
  CHECK_FALSE(lt::z_test(not_a_number, 0, 2).agrees(0.01));
  CHECK_FALSE(lt::z_test(infinite, 0.1, 2).agrees(0.01));
}

TEST_CASE("chi-square: neighbours are pooled, and what is left over joins the last") {
  // 10 + 20 + 30 expect 60 and saw 65; 100 + 5 expect 105 and saw 100.
  const std::vector<double> expected = {10, 20, 30, 100, 5};
  const std::vector<double> observed = {12, 20, 33, 95, 5};
  const lt::ChiSquare test = lt::chi_square(observed, expected);
  CHECK(test.degrees_of_freedom == 1);
  CHECK(test.statistic == Approx(25.0 / 60 + 25.0 / 105));
  CHECK(test.p_value == Approx(std::erfc(std::sqrt(test.statistic / 2))));
  // Without pooling: 4/10 + 0/20 + 9/30 + 25/100 + 0/5.
  const lt::ChiSquare single = lt::chi_square(observed, expected, 0);
  CHECK(single.degrees_of_freedom == 4);
  CHECK(single.statistic == Approx(0.4 + 0.3 + 0.25));
}

TEST_CASE("chi-square: a sample where none can be is never hidden by pooling") {
  const std::vector<double> expected = {100, 0, 100};
  CHECK(lt::chi_square(std::vector<double>{100, 0, 100}, expected).p_value == 1);
  CHECK(lt::chi_square(std::vector<double>{100, 1, 99}, expected).p_value == 0);
  CHECK(
      lt::chi_square(std::vector<double>{100, 0, 100}, std::vector<double>{100, not_a_number, 100})
          .p_value == 0);
  CHECK(lt::chi_square(std::vector<double>{100, not_a_number, 100}, expected).p_value == 0);
  CHECK(lt::chi_square(std::vector<double>{100, 0, 100}, std::vector<double>{150, -50, 100})
            .p_value == 0);
}

TEST_CASE("chi-square: p-values of right samples are uniform, of wrong ones tiny") {
  lt::TestRandom random(11);
  constexpr int bins = 20;
  constexpr int samples = 4000;
  const std::vector<double> expected(bins, static_cast<double>(samples) / bins);
  std::vector<double> p_values;
  for (int repeat = 0; repeat < 400; ++repeat) {
    std::vector<double> right(bins, 0.0);
    for (int i = 0; i < samples; ++i)
      ++right[static_cast<std::size_t>(random.uniform() * bins)];
    p_values.push_back(lt::chi_square(right, expected).p_value);
  }
  CHECK(lt::kolmogorov_smirnov(p_values, uniform_cdf).p_value > 1e-6);

  std::vector<double> wrong(bins, 0.0);
  for (int i = 0; i < samples; ++i)
    ++wrong[static_cast<std::size_t>(std::pow(random.uniform(), 1.2) * bins)];
  CHECK(lt::chi_square(wrong, expected).p_value < 1e-6);
}

TEST_CASE("Kolmogorov-Smirnov: the distance of samples that are placed by hand") {
  // One sample at 0.7: the step at it reaches from 0 to 1 over F = 0.7.
  CHECK(lt::kolmogorov_smirnov({0.7}, uniform_cdf).distance == Approx(0.7));
  // Steps of 1/2 at 0.1 and 0.4: largest just after the second, 1 - 0.4.
  CHECK(lt::kolmogorov_smirnov({0.4, 0.1}, uniform_cdf).distance == Approx(0.6));
  CHECK(lt::kolmogorov_smirnov(samples_at_distance(10, 0.3), uniform_cdf).distance == Approx(0.3));
}

TEST_CASE("Kolmogorov-Smirnov: the printed critical values") {
  const auto p = [](int n, double distance) {
    return lt::kolmogorov_smirnov(samples_at_distance(n, distance), uniform_cdf).p_value;
  };
  // Exact, two-sided, 5 %: n = 10, 20, 50 and 100 (Miller 1956, table 1).
  CHECK(p(10, 0.40925) == Approx(0.05).margin(0.002));
  CHECK(p(20, 0.29408) == Approx(0.05).margin(0.002));
  CHECK(p(50, 0.18841) == Approx(0.05).margin(0.002));
  CHECK(p(100, 0.13403) == Approx(0.05).margin(0.002));
  CHECK(p(10, 0.48893) == Approx(0.01).margin(0.001));
  // The limit for many samples: 1.3581 and 1.6276 over the root of n (Smirnov 1948).
  CHECK(p(1'000'000, 0.0013581) == Approx(0.05).margin(0.0002));
  CHECK(p(1'000'000, 0.0016276) == Approx(0.01).margin(0.0001));
}

TEST_CASE("Kolmogorov-Smirnov: p-values of right samples are uniform, of wrong ones tiny") {
  lt::TestRandom random(12);
  std::vector<double> p_values;
  std::vector<double> cubes;
  for (int repeat = 0; repeat < 300; ++repeat) {
    std::vector<double> samples;
    for (int i = 0; i < 300; ++i)
      samples.push_back(random.uniform());
    p_values.push_back(lt::kolmogorov_smirnov(samples, uniform_cdf).p_value);
    for (const double u : samples)
      cubes.push_back(std::cbrt(u));  // distributed like x^3
  }
  CHECK(lt::kolmogorov_smirnov(p_values, uniform_cdf).p_value > 1e-6);
  CHECK(lt::kolmogorov_smirnov(cubes, [](double x) { return x * x * x; }).p_value > 1e-6);
  CHECK(lt::kolmogorov_smirnov(cubes, [](double x) { return x * x; }).p_value < 1e-6);
}

TEST_CASE("Kolmogorov-Smirnov: NaN is never right") {
  CHECK(lt::kolmogorov_smirnov({0.5, not_a_number, 0.6}, uniform_cdf).p_value == 0);
  CHECK(lt::kolmogorov_smirnov({0.5, 0.6}, [](double) { return not_a_number; }).p_value == 0);
}
