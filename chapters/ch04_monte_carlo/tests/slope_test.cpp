#include "ch04_monte_carlo/slope.hpp"

#include <vector>

#include "ch04_monte_carlo/pcg32.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;

TEST_CASE("power law: points on one give its slope and factor, without error") {
  for (const double slope : {-1.5, -0.5, 0.0, 2.0}) {
    std::vector<double> x, y;
    for (const double at : {1.0, 3.0, 10.0, 700.0}) {
      x.push_back(at);
      y.push_back(0.25 * std::pow(at, slope));
    }
    const PowerLaw law = fit_power_law(x, y);
    CHECK(law.slope == Approx(slope).margin(1e-12));
    CHECK(law.factor == Approx(0.25));
    CHECK(law.standard_error < 1e-7);  // the root of rounding
  }
}

TEST_CASE("power law: a fit by hand") {
  // Logarithms x: 0, 1, 2, 3 and y: 0, 2, 1, 3. Deviations from 1.5 and 1.5: xx = 5, yy = 5,
  // xy = 2.25 - 0.25 - 0.25 + 2.25 = 4: slope 4/5, left over 5 - 0.8 * 4 = 1.8, and the error of
  // the slope is the root of 1.8 / 2 / 5. Intercept 1.5 - 0.8 * 1.5 = 0.3.
  const std::vector<double> x{1, std::exp(1), std::exp(2), std::exp(3)};
  const std::vector<double> y{1, std::exp(2), std::exp(1), std::exp(3)};
  const PowerLaw law = fit_power_law(x, y);
  CHECK(law.slope == Approx(0.8));
  CHECK(law.standard_error == Approx(std::sqrt(0.18)));
  CHECK(law.factor == Approx(std::exp(0.3)));
}

TEST_CASE("power law: other units change the factor only") {
  const std::vector<double> x{1, 2, 4, 8}, y{3, 5, 4, 9}, x_in_mm{1e3, 2e3, 4e3, 8e3};
  const PowerLaw law = fit_power_law(x, y);
  const PowerLaw in_mm = fit_power_law(x_in_mm, y);
  CHECK(in_mm.slope == Approx(law.slope));
  CHECK(in_mm.standard_error == Approx(law.standard_error));
  CHECK(in_mm.factor == Approx(law.factor * std::pow(1e3, -law.slope)));
}

TEST_CASE("power law: the standard error is as large as the errors are") {
  // Normal noise on the logarithm of 12 points: (slope - true) / error is Student's t with 10
  // degrees of freedom, whose square has the mean 10 / 8.
  Pcg32 random(2);
  RunningMean t_squared, slopes;
  for (int repeat = 0; repeat < 20'000; ++repeat) {
    std::vector<double> x, y;
    for (int i = 0; i < 12; ++i) {
      double noise = -6;  // the sum of 12 uniform numbers has variance 1 and looks normal
      for (int k = 0; k < 12; ++k)
        noise += random.next_float();
      x.push_back(std::exp2(i));
      y.push_back(std::exp(0.1 * noise - 0.5 * std::log(x.back())));
    }
    const PowerLaw law = fit_power_law(x, y);
    slopes.add(law.slope);
    t_squared.add(std::pow((law.slope + 0.5) / law.standard_error, 2));
  }
  CHECK(z_test(slopes, -0.5).agrees());
  CHECK(z_test(t_squared, 10.0 / 8).agrees(0.02));
}
