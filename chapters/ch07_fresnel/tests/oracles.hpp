// Fresnel's equations in complex arithmetic: one short form for glass and metal, which shares no
// code with the chapter's.
#pragma once

#include <complex>

namespace lt::testing {

inline constexpr double exact_pi = 3.14159265358979323846;
inline constexpr double largest_cosine_step = 1.0 / 999;  // 1,000 cosines from 0 to 1

struct ComplexReflectance {
  double s, p;
  [[nodiscard]] double mean() const { return (s + p) / 2; }
};

// @param m  index beyond / index here: real for glass, complex for metal
inline ComplexReflectance complex_reflectance(double cos_here, std::complex<double> m) {
  const std::complex<double> cos_beyond = std::sqrt(1.0 - (1.0 - cos_here * cos_here) / (m * m));
  const auto share = [](std::complex<double> a, std::complex<double> b) {
    return std::norm((a - b) / (a + b));
  };
  return {share(cos_here, m * cos_beyond), share(m * cos_here, cos_beyond)};
}

}  // namespace lt::testing
