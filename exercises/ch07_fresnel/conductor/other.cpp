// Complex arithmetic from end to end, with the index of those who let waves turn the other way
// round, eta - i k: every length stays the same.
#include "api.hpp"

#include <complex>

namespace exercise {

double fresnel_conductor(double cos_here, double n_here, double eta, double k) {
  using Complex = std::complex<double>;
  const Complex index(eta, -k);
  if (index == n_here) return 0.0;
  const Complex sin_beyond = std::sqrt(Complex(1.0 - cos_here * cos_here)) * n_here / index;
  const Complex cos_beyond = std::sqrt(1.0 - sin_beyond * sin_beyond);
  const Complex s =
      (n_here * cos_here - index * cos_beyond) / (n_here * cos_here + index * cos_beyond);
  const Complex p =
      (index * cos_here - n_here * cos_beyond) / (index * cos_here + n_here * cos_beyond);
  return 0.5 * (std::norm(s) + std::norm(p));
}

Rgb fresnel_conductor(double cos_here, double n_here, Rgb eta, Rgb k) {
  Rgb share;
  for (int channel = 0; channel < 3; ++channel)
    share[channel] = fresnel_conductor(cos_here, n_here, eta[channel], k[channel]);
  return share;
}

}  // namespace exercise
