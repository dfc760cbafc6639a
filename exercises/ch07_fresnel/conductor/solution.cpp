#include "api.hpp"

#include <algorithm>
#include <cmath>

namespace exercise {

namespace {

// Of a complex number.
double squared_length(double real_part, double imaginary_part) {
  return real_part * real_part + imaginary_part * imaginary_part;
}

}  // namespace

double fresnel_conductor(double cos_here, double n_here, double eta, double k) {
  if (eta == n_here && k == 0.0) return 0.0;  // no surface; at the horizon it would be 0 / 0
  // Only the quotient of the indices counts.
  const double squared_eta = (eta / n_here) * (eta / n_here);
  const double squared_k = (k / n_here) * (k / n_here);
  const double squared_cos = cos_here * cos_here;
  const double squared_sin = 1.0 - squared_cos;

  // a + i b = sqrt((eta + i k)^2 - sin^2) is the index times the cosine beyond.
  const double real_part = squared_eta - squared_k - squared_sin;  // negative for most metals
  const double squared_imaginary_part = 4.0 * squared_eta * squared_k;
  const double length = std::sqrt(real_part * real_part + squared_imaginary_part);
  const double a = std::sqrt(std::max(0.0, (length + real_part) / 2.0));
  const double b = std::sqrt(std::max(0.0, (length - real_part) / 2.0));

  const double s = squared_length(a - cos_here, b) / squared_length(a + cos_here, b);
  const double p = s * squared_length(a * cos_here - squared_sin, b * cos_here) /
                   squared_length(a * cos_here + squared_sin, b * cos_here);
  return (s + p) / 2.0;
}

Rgb fresnel_conductor(double cos_here, double n_here, Rgb eta, Rgb k) {
  return {fresnel_conductor(cos_here, n_here, eta.r, k.r),
          fresnel_conductor(cos_here, n_here, eta.g, k.g),
          fresnel_conductor(cos_here, n_here, eta.b, k.b)};
}

}  // namespace exercise
