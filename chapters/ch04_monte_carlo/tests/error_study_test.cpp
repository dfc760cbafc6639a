#include "ch04_monte_carlo/error_study.hpp"

#include <cmath>
#include <numbers>

#include "ch04_monte_carlo/error_plots.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

constexpr double pi_itself = std::numbers::pi;

// Variance of the stratified estimate of the sine's integral over [0, pi]: for each part the width
// times the integral of sin^2 (x/2 - sin(2x)/4) minus the square of that of sin (-cos).
double stratified_sine_variance(int n) {
  const double width = pi_itself / n;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double a = i * width;
    const double b = a + width;
    const double squares = width / 2 - (std::sin(2 * b) - std::sin(2 * a)) / 4;
    const double integral = std::cos(a) - std::cos(b);
    sum += width * squares - integral * integral;
  }
  return sum;
}

std::vector<ErrorAtN> errors_of(const NamedEstimator& way, int factor = 2) {
  return measure_error(way.estimate, way.exact, 16, 16384, 200, 1, factor);
}

void check_slope(const NamedEstimator& way, double expected, int factor = 2) {
  const PowerLaw law = law_of(errors_of(way, factor));
  INFO(way.name << ": " << law.slope << " +- " << law.standard_error);
  CHECK(z_test(law.slope, law.standard_error, expected).agrees());
  CHECK(law.slope == Approx(expected).margin(0.06));
}

}  // namespace

TEST_CASE("error: of the plain estimate is the root of variance over n") {
  // Variances: sine pi^2/2 - 4; edge 1/3 * 2/3.
  for (const ErrorAtN& error : errors_of(plain(sine())))
    CHECK(z_test(error.squares, (pi_itself * pi_itself / 2 - 4) / error.n).agrees());
  for (const ErrorAtN& error : errors_of(plain(edge())))
    CHECK(z_test(error.squares, 2.0 / 9 / error.n).agrees());
}

TEST_CASE("error: of the stratified estimate is what its parts' variances add up to") {
  for (const ErrorAtN& error : errors_of(stratified(sine()))) {
    if (error.n <= 1024)  // beyond, the sum itself is lost to rounding
      CHECK(z_test(error.squares, stratified_sine_variance(error.n)).agrees());
    // Many parts: f' is constant in each, variance width^2 / 12 f'^2: pi^4 / 24 / n^3 in all.
    const double limit = std::pow(pi_itself, 4) / 24 / std::pow(error.n, 3);
    CHECK(z_test(error.squares, limit).agrees(0.01));
  }
  // Only the part with the edge has a variance. The edge lies at 1/3 or 2/3 of it, for every power
  // of 2: 2/9 of the part's square.
  for (const ErrorAtN& error : errors_of(stratified(edge())))
    CHECK(z_test(error.squares, 2.0 / 9 / error.n / error.n).agrees());
}

TEST_CASE("slopes: -1/2 plain, -3/2 stratified where smooth, -1 with an edge") {
  check_slope(plain(sine()), -0.5);
  check_slope(plain(parabola()), -0.5);
  check_slope(plain(edge()), -0.5);
  check_slope(stratified(sine()), -1.5);
  check_slope(stratified(parabola()), -1.5);
  check_slope(stratified(edge()), -1.0);
}

TEST_CASE("slopes: -3/4 for stratified darts, whose rim is cut by the root of n cells") {
  check_slope(stratified_pi(), -0.75, 4);
}

TEST_CASE("error: each n has its own streams") {
  std::vector<std::uint32_t> first_draws;
  const Estimator note = [&](int, Pcg32& random) {
    first_draws.push_back(random.next_bits());
    return 0.0;
  };
  static_cast<void>(measure_error(note, 0, 1, 8, 3, 1));
  REQUIRE(first_draws.size() == 12);
  for (std::size_t i = 0; i < first_draws.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      CHECK(first_draws[i] != first_draws[j]);
}
