#include "api.hpp"

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::estimate_uniform;
using exercise::RunningMean;
using lt::text_of;
using Numbers = std::vector<double>;

RunningMean mean_of(const Numbers& numbers) {
  RunningMean running;
  for (const double number : numbers)
    running.add(number);
  return running;
}

std::string gave(const std::string& call, double value, double expected) {
  return call + " gave " + text_of(value) + " and should give " + text_of(expected) + ".";
}

bool is_near(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b));  // false for NaN
}

bool is_right(const std::string& call, double value, double expected) {
  if (!is_near(value, expected)) UNSCOPED_INFO(gave(call, value, expected));
  return is_near(value, expected);
}

// sin over [0, pi]: the integral is 2, and pi sin x for uniform x has the variance
// pi^2 <sin^2> - 2^2 = pi^2 / 2 - 4.
constexpr double pi = std::numbers::pi;
constexpr double variance_of_sine = pi * pi / 2 - 4;

RunningMean estimate_sine(int n, lt::TestRandom& random) {
  return estimate_uniform([](double x) { return std::sin(x); }, 0, pi, n,
                          [&random] { return random.uniform(); });
}

}  // namespace

TEST_CASE("1, 2, 3 and 4 have mean 2.5, variance 5/3 and standard error sqrt(5/12)") {
  // Distances -1.5, -0.5, 0.5, 1.5; their squares sum to 5.
  const RunningMean four = mean_of({1, 2, 3, 4});
  const std::string of_four = " of 1, 2, 3, 4";
  REQUIRE(four.count() == 4);
  REQUIRE(is_right("mean()" + of_four, four.mean(), 2.5));
  const double variance = four.variance();
  lt::diagnose(!is_near(variance, 5.0 / 4), "n-instead-of-n-minus-1",
               gave("variance()" + of_four, variance, 5.0 / 3));
  // From the means before each number, 0, 1, 1.5 and 2: 1 + 1 + 2.25 + 4 = 8.25, or 7.25 if the
  // first number counts as its own mean. From those after, 1, 1.5, 2 and 2.5: 3.5. Over 3 or 4.
  for (const double sum : {8.25, 7.25, 3.5})
    lt::diagnose(!is_near(variance, sum / 3) && !is_near(variance, sum / 4), "same-mean-twice",
                 gave("variance()" + of_four, variance, 5.0 / 3));
  REQUIRE(is_right("variance()" + of_four, variance, 5.0 / 3));

  const double error = four.standard_error();
  const std::string seen = gave("standard_error()" + of_four, error, std::sqrt(5.0 / 12));
  lt::diagnose(!is_near(error, std::sqrt(5.0 / 3)), "variance-not-over-n", seen);
  lt::diagnose(!is_near(error, 5.0 / 12), "root-forgotten", seen);
  lt::diagnose(!is_near(error, std::sqrt(5.0 / 3) / 4), "divided-by-n-not-root-n", seen);
  REQUIRE(is_right("standard_error()" + of_four, error, std::sqrt(5.0 / 12)));
}

TEST_CASE("no number, one number and two") {
  const RunningMean none;
  REQUIRE(none.count() == 0);
  REQUIRE(is_right("mean() of no number", none.mean(), 0));
  REQUIRE(is_right("variance() of no number", none.variance(), 0));
  REQUIRE(is_right("standard_error() of no number", none.standard_error(), 0));
  const RunningMean one = mean_of({7});
  REQUIRE(is_right("mean() of 7", one.mean(), 7));
  lt::diagnose(!std::isnan(one.variance()), "one-number-divides-by-zero",
               gave("variance() of 7 alone", one.variance(), 0));
  lt::diagnose(!std::isnan(one.standard_error()), "one-number-divides-by-zero",
               gave("standard_error() of 7 alone", one.standard_error(), 0));
  REQUIRE(is_right("variance() of 7 alone", one.variance(), 0));
  REQUIRE(is_right("standard_error() of 7 alone", one.standard_error(), 0));
  REQUIRE(is_right("mean() of -1 and 5", mean_of({-1, 5}).mean(), 2));
}

TEST_CASE("the numbers may be large and near each other") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    // Multiples of 2^-10 have enough digits left for 1e9 in front: both sums are exact.
    Numbers plain, offset;
    for (int i = 0; i < 1000; ++i) {
      plain.push_back(static_cast<double>(random.next_bits() >> 54) * 0x1p-10);
      offset.push_back(1e9 + plain.back());
    }
    const double before = mean_of(plain).variance();
    const double after = mean_of(offset).variance();
    std::ostringstream seen;
    seen << "1,000 numbers between 0 and 1 have variance " << text_of(before)
         << "; with 1,000,000,000 added to each it should be the same and is " << text_of(after)
         << '.';
    // The distances are rounded to 1e-7 at 1e9, a millionth of them.
    const bool is_kept = std::abs(after / before - 1) < 1e-4;
    const bool is_right_when_small = is_near(mean_of({1, 2, 3, 4}).variance(), 5.0 / 3);
    lt::diagnose(is_kept || !is_right_when_small, "ex2-minus-e2x", seen.str());
    if (!is_kept) UNSCOPED_INFO(seen.str());
    REQUIRE(is_kept);
  }
}

TEST_CASE("the integral of sin from 0 to pi is 2") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    constexpr int n = 20'000;
    const RunningMean found = estimate_sine(n, random);
    if (found.count() != n)
      UNSCOPED_INFO("count() is " << found.count() << "; " << n << " points were asked for.");
    REQUIRE(found.count() == n);
    const std::string call = "the integral of sin from 0 to pi";
    const std::string seen = gave(call, found.mean(), 2);
    // The tests know the spread. Its 6 standard errors are 0.041; wrong answers are 80 and more
    // off.
    const double error = std::sqrt(variance_of_sine / n);
    const auto agrees = [&](double expected) {
      return lt::z_test(found.mean(), error, expected).agrees(0.01);
    };
    lt::diagnose(!agrees(2 / pi), "width-forgotten", seen);
    lt::diagnose(!agrees(pi * (1 - std::cos(1.0))), "points-in-0-1", seen);
    if (!agrees(2)) UNSCOPED_INFO(seen);
    REQUIRE(agrees(2));

    // Ends in any order, and not at 0: the integral of x^2 from 3 to 1 is (1 - 27) / 3. Not of x:
    // its mean is right for points all over 0 to 4, too.
    const RunningMean backwards = estimate_uniform([](double x) { return x * x; }, 3, 1, n,
                                                   [&random] { return random.uniform(); });
    // Of -2 x^2: 4 (E[x^4] - E[x^2]^2), where E[x^4] is (3^5 - 1) / 10 and E[x^2] is 13 / 3.
    const double error_backwards = std::sqrt(4 * (24.2 - 169.0 / 9) / n);
    const bool is_right_backwards =
        lt::z_test(backwards.mean(), error_backwards, -26.0 / 3).agrees(0.01);
    if (!is_right_backwards)
      UNSCOPED_INFO(gave("the integral of x^2 from 3 to 1", backwards.mean(), -26.0 / 3));
    REQUIRE(is_right_backwards);
  }
}

TEST_CASE("95 of 100 intervals of 1.96 standard errors hold the true value") {
  int last_count = 0;
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    int holding = 0;
    for (int i = 0; i < 400; ++i) {
      const RunningMean found = estimate_sine(250, random);
      holding += std::abs(found.mean() - 2) <= 1.959964 * found.standard_error();
    }
    last_count = holding;
    // 380 of 400 are expected. Fewer than 353 come with probability 3e-8, all 400 with 1e-9
    // (binomial distribution with p = 0.95).
    if (holding < 353 || holding > 399)
      UNSCOPED_INFO(holding << " of 400 intervals hold 2; it should be about 380."
                            << (holding > 399 ? " Are the points independent of each other?" : ""));
    REQUIRE((holding >= 353 && holding <= 399));
  }
  lt::measured(std::to_string(last_count) + " of 400 intervals of 1.96 standard errors hold the " +
               "integral of sin, 2; 380 were expected");
}
