/// @file
/// What the checker of exercise 07.2 compares with: Fresnel's fractions in complex arithmetic, and
/// what each mistake makes of them.
#pragma once

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "api.hpp"

namespace oracle {

using Complex = std::complex<double>;

inline double squared(double x) {
  return x * x;
}

inline bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6;  // double arithmetic is much closer; NaN never is
}

struct Place {
  double c, n_here, eta, k;
};

struct Amplitudes {
  Complex s, p;
};
inline double mean_of_norms(Amplitudes r) {
  return (std::norm(r.s) + std::norm(r.p)) / 2;
}

// Fresnel's fractions in complex arithmetic; m is the quotient of the indices.
inline Complex quotient(Place at) {
  return {at.eta / at.n_here, at.k / at.n_here};
}
inline Amplitudes amplitudes(Place at, double squared_sin) {
  const Complex m = quotient(at);
  const Complex t = std::sqrt(1.0 - squared_sin / (m * m));  // the cosine beyond
  return {(at.c - m * t) / (at.c + m * t), (m * at.c - t) / (m * at.c + t)};
}
inline double exact(Place at) {
  return mean_of_norms(amplitudes(at, 1 - squared(at.c)));
}

// The same from q = a + i b, which is m times the cosine beyond, right or wrong.
inline double from_root(Place at, double squared_sin, Complex q) {
  const Complex s = (at.c - q) / (at.c + q);
  return mean_of_norms({s, s * (q * at.c - squared_sin) / (q * at.c + squared_sin)});
}
// Of thesis eq. 9 as printed: the outer index, divided by itself, stands in a and b for eta.
inline Complex printed_root(Place at, Complex square) {
  const double printed = square.real() - squared(quotient(at).real()) + 1;
  return {std::sqrt((std::abs(square) + printed) / 2), std::sqrt((std::abs(square) - printed) / 2)};
}

// What each mistake gives; sin2 is right, square the right (eta + i k)^2 - sin2.
struct Parts {
  Amplitudes r;
  double sin2;
  Complex square;
};
using Wrong = double (*)(Place at, Parts x);
inline const std::vector<std::pair<const char*, Wrong>> mistakes{
    {"k-forgotten",
     [](Place at, Parts) {
       return exact({at.c, at.n_here, at.eta, 0});
     }},
    {"cosine-not-squared", [](Place at, Parts) { return mean_of_norms(amplitudes(at, 1 - at.c)); }},
    {"cosine-not-squared",
     [](Place at, Parts x) {
       return from_root(at, 1 - at.c, std::sqrt(x.square + x.sin2 - (1 - at.c)));
     }},
    {"outside-forgotten",
     [](Place at, Parts) {
       return exact({at.c, 1, at.eta, at.k});
     }},
    {"k-not-divided",
     [](Place at, Parts) {
       return exact({at.c, at.n_here, at.eta, at.k * at.n_here});
     }},
    {"angle-ignored",
     [](Place at, Parts) {
       return exact({1, at.n_here, at.eta, at.k});
     }},
    {"cosine-taken-for-one", [](Place at, Parts) { return mean_of_norms(amplitudes(at, 0)); }},
    {"k-added",
     [](Place at, Parts x) {
       return from_root(at, x.sin2, std::sqrt(x.square + 2 * squared(quotient(at).imag())));
     }},
    {"sine-forgotten",
     [](Place at, Parts x) { return from_root(at, x.sin2, std::sqrt(x.square + x.sin2)); }},
    {"half-forgotten",
     [](Place at, Parts x) { return from_root(at, x.sin2, std::sqrt(2.0 * x.square)); }},
    {"square-for-fourth-power",
     [](Place at, Parts x) {
       const double length = std::hypot(x.square.real(), x.square.imag() * at.n_here);
       return from_root(
           at, x.sin2,
           {std::sqrt((length + x.square.real()) / 2), std::sqrt((length - x.square.real()) / 2)});
     }},
    {"b-without-cosine",
     [](Place at, Parts x) {
       const Complex q = std::sqrt(x.square);
       const double p = (squared(q.real() * at.c - x.sin2) + squared(q.imag())) /
                        (squared(q.real() * at.c + x.sin2) + squared(q.imag()));
       return std::norm(x.r.s) * (1 + p) / 2;
     }},
    {"total-reflection-by-eta",
     [](Place at, Parts x) {
       const bool has_no_angle = x.sin2 >= squared(quotient(at).real());
       return has_no_angle ? 1 : mean_of_norms(x.r);
     }},
    {"imaginary-part-forgotten",
     [](Place at, Parts x) { return from_root(at, x.sin2, std::sqrt(Complex(x.square.real()))); }},
    {"printed-formula",
     [](Place at, Parts x) { return from_root(at, x.sin2, printed_root(at, x.square)); }},
    {"p-without-s",
     [](Place, Parts x) {
       return mean_of_norms({x.r.s, x.r.p / x.r.s});
     }},
    {"s-only", [](Place, Parts x) { return std::norm(x.r.s); }},
    {"sum-not-mean", [](Place, Parts x) { return 2 * mean_of_norms(x.r); }},
    {"not-squared", [](Place, Parts x) { return (std::abs(x.r.s) + std::abs(x.r.p)) / 2; }},
    // Conventions differ in the sign of one of the two.
    {"mean-before-square", [](Place, Parts x) { return std::norm(x.r.s + x.r.p) / 4; }},
    {"mean-before-square", [](Place, Parts x) { return std::norm(x.r.s - x.r.p) / 4; }},
    {"real-part-only",
     [](Place, Parts x) { return (squared(x.r.s.real()) + squared(x.r.p.real())) / 2; }},
    {"complex-square", [](Place, Parts x) { return (x.r.s * x.r.s + x.r.p * x.r.p).real() / 2; }},
    {"schlick",
     [](Place at, Parts) {
       const double straight_on = exact({1, at.n_here, at.eta, at.k});
       return straight_on + (1 - straight_on) * std::pow(1 - at.c, 5);
     }},
};

}  // namespace oracle
