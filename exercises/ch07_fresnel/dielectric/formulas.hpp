/// @file
/// What the checker of exercise 07.1 compares with: Fresnel's fractions, right and wrong.
#pragma once

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "api.hpp"

namespace oracle {

using exercise::Reflectance;

inline double squared(double x) {
  return x * x;
}

struct Place {
  double c, n_here, n_beyond;
};

// Fresnel's equations in complex arithmetic: beyond the critical angle the cosine is imaginary, and
// total reflection comes out by itself.
inline Reflectance exact(Place at) {
  const double m = at.n_beyond / at.n_here;
  const std::complex<double> t = std::sqrt(std::complex<double>(1 - (1 - squared(at.c)) / (m * m)));
  return {std::norm((at.c - m * t) / (at.c + m * t)), std::norm((m * at.c - t) / (m * at.c + t))};
}

// Fresnel's fractions if t is taken for the cosine beyond.
inline double r_s(Place at, double t) {
  return (at.n_here * at.c - at.n_beyond * t) / (at.n_here * at.c + at.n_beyond * t);
}
inline double r_p(Place at, double t) {
  return (at.n_beyond * at.c - at.n_here * t) / (at.n_beyond * at.c + at.n_here * t);
}
inline Reflectance shares(Place at, double t) {
  return {squared(r_s(at, t)), squared(r_p(at, t))};
}
inline double snell(double c, double eta) {
  return std::sqrt(1 - eta * eta * (1 - c * c));
}
inline double eta_of(Place at) {
  return at.n_here / at.n_beyond;
}
inline double snell(Place at) {
  return snell(at.c, eta_of(at));
}
inline Place back(Place at) {
  return {at.c, at.n_beyond, at.n_here};
}

using WrongCosine = double (*)(double c, double eta);
inline const std::vector<std::pair<const char*, WrongCosine>> wrong_cosines{
    {"eta-inverted", [](double c, double eta) { return snell(c, 1 / eta); }},
    {"cosine-for-sine", [](double c, double eta) { return std::sqrt(1 - squared(eta * c)); }},
    {"smaller-index-above", [](double c, double eta) { return snell(c, eta < 1 ? eta : 1 / eta); }},
    {"eta-not-squared", [](double c, double eta) { return snell(c, std::sqrt(eta)); }},
    {"cosine-not-squared", [](double c, double eta) { return snell(std::sqrt(c), eta); }},
    {"snell-of-cosines", [](double c, double eta) { return eta * c; }},
    {"no-bending", [](double c, double) { return c; }},
    {"root-forgotten", [](double c, double eta) { return squared(snell(c, eta)); }},
};

}  // namespace oracle
