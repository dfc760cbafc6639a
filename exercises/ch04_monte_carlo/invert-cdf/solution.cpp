#include "api.hpp"

#include <cmath>

namespace exercise {

double sample_parabola(double u) {
  // P(x) = x^3. With u = 0 the sample would be 0, where p is 0 and f / p is 0 / 0. 1 - u is as
  // uniform as u, and never 0.
  return std::cbrt(1.0 - u);
}

double parabola_pdf(double x) {
  if (x < 0.0 || x > 1.0) return 0.0;
  return 3.0 * x * x;  // the 3 makes the area 1
}

double sample_exponential(double u) {
  // P(x) = 1 - e^-x, so that e^-x = 1 - u, which is never 0: the logarithm is finite.
  return -std::log(1.0 - u);
}

double exponential_pdf(double x) {
  return x < 0.0 ? 0.0 : std::exp(-x);
}

}  // namespace exercise
