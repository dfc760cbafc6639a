// No inverse function: the cumulative distribution is searched by halving, as one must where a
// formula for its inverse does not exist.
#include "api.hpp"

#include <cmath>

namespace exercise {

namespace {

// Where a rising function reaches u, between low and high; never quite at low.
template <class Cdf>
double solve(const Cdf& cdf, double u, double low, double high) {
  for (int step = 0; step < 64; ++step) {
    const double middle = low + (high - low) / 2.0;
    (cdf(middle) <= u ? low : high) = middle;
  }
  return high;
}

}  // namespace

double sample_parabola(double u) {
  return solve([](double x) { return x * x * x; }, u, 0.0, 1.0);
}

double parabola_pdf(double x) {
  return std::abs(x - 0.5) <= 0.5 ? 3.0 * std::pow(x, 2.0) : 0.0;
}

double sample_exponential(double u) {
  return solve([](double x) { return -std::expm1(-x); }, u, 0.0, 64.0);
}

double exponential_pdf(double x) {
  return x >= 0.0 ? 1.0 / std::exp(x) : 0.0;
}

}  // namespace exercise
