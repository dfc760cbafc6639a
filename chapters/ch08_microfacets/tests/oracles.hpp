/// @file
/// The same formulas in other forms and in double, written from the papers and not from the code;
/// and integrals over directions.
#pragma once

#include <cmath>

#include "common/math.hpp"

namespace lt::testing {

inline constexpr double pi_ = 3.14159265358979323846;

/// Walter et al. 2007, eq. 33, by the angle of the facet's normal.
inline double d_by_angle(double alpha, double theta) {
  const double c = std::cos(theta);
  const double t = std::tan(theta);
  const double sum = alpha * alpha + t * t;
  return alpha * alpha / (pi_ * c * c * c * c * sum * sum);
}

/// 2 mu / (mu + sqrt(mu^2 + alpha^2 (1 - mu^2))): eq. 34 without a tangent.
inline double g1_by_cosine(double alpha, double mu) {
  return 2 * mu / (mu + std::sqrt(mu * mu + alpha * alpha * (1 - mu * mu)));
}

/// 2 mu_o mu_i / (mu_i s_o + mu_o s_i), Heitz 2014, eq. 99 multiplied out.
inline double g2_by_cosines(double alpha, double mu_o, double mu_i) {
  const auto s = [=](double mu) { return std::sqrt(mu * mu + alpha * alpha * (1 - mu * mu)); };
  return 2 * mu_o * mu_i / (mu_i * s(mu_o) + mu_o * s(mu_i));
}

/// The integral over the upper hemisphere of `f(h)`, which may have a peak of width `alpha` around
/// z: a grid of steps x steps midpoints, with tan(theta) = alpha s and s = v / (1 - v).
template <class F>
double integrate_facets(double alpha, int steps, const F& f) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double v = (i + 0.5) / steps;
    const double t = alpha * v / (1 - v);
    const double c = 1 / std::sqrt(1 + t * t);
    // sin(theta) d(theta) = t c^3 dt, dt = alpha / (1 - v)^2 dv
    const double solid_angle = t * c * c * c * alpha / ((1 - v) * (1 - v));
    for (int j = 0; j < steps; ++j) {
      const double phi = 2 * pi_ * (j + 0.5) / steps;
      sum += solid_angle * f(vec3(t * c * std::cos(phi), t * c * std::sin(phi), c));
    }
  }
  return 2 * pi_ * sum / steps / steps;
}

/// Share of light that facets with F = 1 reflect, by an integral over *facets*: a facet h sends
/// D (wo h) G2 / mu_o of it on, if what it sends goes up.
inline double albedo_over_facets(double alpha, double mu, bool correlated, int steps) {
  const double sine = std::sqrt(1 - mu * mu);
  return integrate_facets(alpha, steps, [=](vec3 h) {
    const double theta = std::atan2(std::hypot(double{h.x}, double{h.y}), double{h.z});
    const double wo_h = sine * h.x + mu * h.z;
    const double mu_i = 2 * wo_h * h.z - mu;
    if (wo_h <= 0 || mu_i <= 0) return 0.0;
    const double g = correlated ? g2_by_cosines(alpha, mu, mu_i)
                                : g1_by_cosine(alpha, mu) * g1_by_cosine(alpha, mu_i);
    return d_by_angle(alpha, theta) * wo_h * g / mu;
  });
}

inline vec3 at_degrees(float degrees) {
  return {std::sin(radians(degrees)), 0.0f, std::cos(radians(degrees))};
}

/// Angles to the normal, degrees, and widths, for every grid of this chapter's tests.
inline constexpr float nine_angles[] = {0, 10, 20, 30, 45, 60, 75, 84, 88};
inline constexpr float five_alphas[] = {0.05f, 0.1f, 0.3f, 0.6f, 1.0f};

}  // namespace lt::testing
