#include "common/testkit/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace lt {

// [welford]
void RunningMean::add(double value) {
  ++count_;
  const double delta = value - mean_;
  mean_ += delta / static_cast<double>(count_);
  sum_of_squares_ += delta * (value - mean_);
}
// [welford]

// [standard-error]
double RunningMean::variance() const {
  return count_ < 2 ? 0 : sum_of_squares_ / static_cast<double>(count_ - 1);
}

double RunningMean::standard_error() const {
  return count_ < 1 ? 0 : std::sqrt(variance() / static_cast<double>(count_));
}
// [standard-error]

// [agrees]
bool ZTest::agrees(double smallest_effect) const {
  if (std::isnan(z) || std::isnan(effect)) return false;
  return std::abs(z) <= 6 || std::abs(effect) <= smallest_effect;
}
// [agrees]

// [z-test]
ZTest z_test(double mean, double standard_error, double expected) {
  const double difference = mean - expected;
  const double effect = expected == 0 ? difference : difference / std::abs(expected);
  if (difference == 0 && standard_error >= 0) return {0, 0};
  if (standard_error == 0)
    return {std::copysign(std::numeric_limits<double>::infinity(), difference), effect};
  return {difference / standard_error, effect};
}
// [z-test]

ZTest z_test(const RunningMean& sample, double expected) {
  return z_test(sample.mean(), sample.standard_error(), expected);
}

namespace {

// Regularised lower incomplete gamma function P(a, x) by its series (Abramowitz and Stegun 6.5.29).
double gamma_p_series(double a, double x) {
  double term = 1 / a;
  double sum = term;
  for (double n = a + 1; std::abs(term) > std::abs(sum) * 1e-17; ++n) {
    term *= x / n;
    sum += term;
  }
  return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

// Regularised upper incomplete gamma function Q(a, x) by its continued fraction (A. and S. 6.5.31),
// evaluated from the front (Lentz 1976).
double gamma_q_fraction(double a, double x) {
  constexpr double tiny = 1e-300;
  double b = x + 1 - a;
  double c = 1 / tiny;
  double d = 1 / b;
  double product = d;
  for (int i = 1; i < 100000; ++i) {
    const double numerator = -i * (i - a);
    b += 2;
    d = numerator * d + b;
    d = 1 / (std::abs(d) < tiny ? tiny : d);
    c = b + numerator / c;
    if (std::abs(c) < tiny) c = tiny;
    product *= c * d;
    if (std::abs(c * d - 1) < 1e-16) break;
  }
  return product * std::exp(a * std::log(x) - x - std::lgamma(a));
}

}  // namespace

double chi_square_tail(double x, int degrees_of_freedom) {
  assert(degrees_of_freedom >= 1);
  if (std::isnan(x)) return 0;  // no statistic, no agreement
  if (x <= 0) return 1;
  if (std::isinf(x)) return 0;
  const double a = 0.5 * degrees_of_freedom;
  // Each form where it converges fast.
  return x / 2 < a + 1 ? 1 - gamma_p_series(a, x / 2) : gamma_q_fraction(a, x / 2);
}

namespace {

struct Bin {
  double observed, expected;
};

// Where nothing can fall, nothing may have fallen: pooling must not hide it. Nor NaN.
bool is_impossible(const Bin& bin) {
  return (bin.expected == 0 && bin.observed != 0) || !(bin.expected >= 0) || !(bin.observed >= 0);
}

// [pooled]
// Neighbours together, until each bin expects enough; what is left over joins the last.
std::vector<Bin> pooled(const std::vector<Bin>& bins, double least) {
  std::vector<Bin> result;
  Bin open{0, 0};
  for (const Bin& bin : bins) {
    open = {open.observed + bin.observed, open.expected + bin.expected};
    if (open.expected < least || open.expected == 0) continue;
    result.push_back(open);
    open = {0, 0};
  }
  if (result.empty()) return {open};
  result.back().observed += open.observed;
  result.back().expected += open.expected;
  return result;
}
// [pooled]

}  // namespace

// [chi-square]
ChiSquare chi_square(std::span<const double> observed, std::span<const double> expected,
                     double pool_below) {
  assert(observed.size() == expected.size());
  std::vector<Bin> bins;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    bins.push_back({observed[i], expected[i]});
    if (is_impossible(bins.back())) return {std::numeric_limits<double>::infinity(), 1, 0};
  }
  bins = pooled(bins, pool_below);

  double statistic = 0;
  for (const Bin& bin : bins) {
    const double difference = bin.observed - bin.expected;
    if (bin.expected > 0) statistic += difference * difference / bin.expected;
  }
  const int degrees_of_freedom = std::max(1, static_cast<int>(bins.size()) - 1);
  return {statistic, degrees_of_freedom, chi_square_tail(statistic, degrees_of_freedom)};
}
// [chi-square]

namespace {

// [kolmogorov-tail]
// Upper tail of Kolmogorov's distribution: 2 sum (-1)^(k-1) exp(-2 k^2 t^2).
double kolmogorov_tail(double t) {
  if (t < 0.2) return 1;  // the series converges slowly there, and 1 - Q < 1e-12
  double sum = 0;
  for (int k = 1; k <= 100; ++k) {
    const double term = std::exp(-2 * k * k * t * t);
    sum += k % 2 == 1 ? term : -term;
    if (term < 1e-17) break;
  }
  return std::clamp(2 * sum, 0.0, 1.0);
}
// [kolmogorov-tail]

}  // namespace

// [kolmogorov-smirnov]
KolmogorovSmirnov kolmogorov_smirnov(std::vector<double> samples,
                                     const std::function<double(double)>& cdf) {
  assert(!samples.empty());
  if (std::any_of(samples.begin(), samples.end(), [](double x) { return std::isnan(x); }))
    return {1, 0};
  std::sort(samples.begin(), samples.end());
  const auto n = static_cast<double>(samples.size());
  double distance = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double f = cdf(samples[i]);
    if (std::isnan(f)) return {1, 0};
    const auto below = static_cast<double>(i);
    distance = std::max({distance, f - below / n, (below + 1) / n - f});
  }
  const double root = std::sqrt(n);
  return {distance, kolmogorov_tail(distance * (root + 0.12 + 0.11 / root))};
}
// [kolmogorov-smirnov]

}  // namespace lt
