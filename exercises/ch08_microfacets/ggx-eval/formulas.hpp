/// @file
/// What the checker of exercise 08.3 compares with: the BRDF of its parts, and what each mistake
/// makes of it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "api.hpp"

namespace oracle {

using exercise::ggx_d;
using exercise::smith_g2;
using glm::dvec3;
using std::numbers::pi;

// To the viewer, and where light comes from: unit vectors with few digits, not in one plane with z.
inline const dvec3 wo{0.6, 0, 0.8}, wi{0.28, 0.576, 0.768}, flat{-0.48, 0.8, 0.36};
inline const std::array<std::pair<dvec3, dvec3>, 3> pairs{{{wo, wi}, {wi, wo}, {flat, wo}}};
inline const double alpha = 0.5;

// Facets whose share tells the cosine that was asked for.
inline double telling(double cosine) {
  return 0.1 + 0.6 * cosine * cosine;
}

// Walter and others 2007, eq. 20, of all that comes into it.
struct Parts {
  dvec3 o, i, h;
  double cos_h, d, g;
  Parts(dvec3 to, dvec3 from)
      : o(to),
        i(from),
        h(normalize(to + from)),
        cos_h(dot(to, h)),
        d(ggx_d(alpha, h)),
        g(smith_g2(alpha, to, from)) {}
  [[nodiscard]] double f() const { return telling(cos_h) * d * g / (4 * o.z * i.z); }
};

inline bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-6 * std::max(1.0, std::abs(b));  // false for NaN
}

using Mistake = double (*)(const Parts& p);

// What stands for F, the rest being right.
inline double with_share(const Parts& p, double share) {
  return p.f() / telling(p.cos_h) * share;
}

// What D and G are asked for, the rest being right.
inline double with_widths(const Parts& p, double of_d, double of_g) {
  return p.f() / (p.d * p.g) * ggx_d(of_d, p.h) * smith_g2(of_g, p.o, p.i);
}

inline const std::vector<std::pair<const char*, Mistake>> mistakes{
    {"four-forgotten", [](const Parts& p) { return 4 * p.f(); }},
    {"pi-for-four", [](const Parts& p) { return 4 * p.f() / pi; }},
    {"d-forgotten", [](const Parts& p) { return p.f() / p.d; }},
    {"g-forgotten", [](const Parts& p) { return p.f() / p.g; }},
    {"fresnel-forgotten", [](const Parts& p) { return with_share(p, 1); }},
    {"cosine-multiplied", [](const Parts& p) { return p.f() * p.i.z; }},
    {"one-cosine", [](const Parts& p) { return p.f() * p.o.z; }},
    {"no-cosines", [](const Parts& p) { return p.f() * p.o.z * p.i.z; }},
    {"cosines-above", [](const Parts& p) { return p.f() * std::pow(p.o.z * p.i.z, 2); }},
    {"jacobian", [](const Parts& p) { return p.f() * p.o.z * p.i.z / p.cos_h; }},
    {"jacobian", [](const Parts& p) { return p.f() * p.o.z * p.i.z / p.cos_h / p.cos_h; }},
    {"fresnel-from-n-dot-o", [](const Parts& p) { return with_share(p, telling(p.o.z)); }},
    {"fresnel-from-n-dot-i", [](const Parts& p) { return with_share(p, telling(p.i.z)); }},
    {"fresnel-from-n-dot-h", [](const Parts& p) { return with_share(p, telling(p.h.z)); }},
    {"fresnel-from-o-dot-i",
     [](const Parts& p) { return with_share(p, telling(std::max(0.0, dot(p.o, p.i)))); }},
    {"fresnel-from-sine",
     [](const Parts& p) { return with_share(p, telling(std::sqrt(1 - p.cos_h * p.cos_h))); }},
    {"one-minus-fresnel", [](const Parts& p) { return with_share(p, 1 - telling(p.cos_h)); }},
    {"d-from-wi", [](const Parts& p) { return p.f() / p.d * ggx_d(alpha, p.i); }},
    {"d-from-wo", [](const Parts& p) { return p.f() / p.d * ggx_d(alpha, p.o); }},
    {"alpha-squared", [](const Parts& p) { return with_widths(p, alpha * alpha, alpha); }},
    {"alpha-squared", [](const Parts& p) { return with_widths(p, alpha, alpha * alpha); }},
    {"alpha-squared", [](const Parts& p) { return with_widths(p, alpha * alpha, alpha * alpha); }},
    {"g-from-h", [](const Parts& p) { return p.f() / p.g * smith_g2(alpha, p.h, p.h); }},
    {"g-from-h", [](const Parts& p) { return p.f() / p.g * smith_g2(alpha, p.o, p.h); }},
    {"g-from-h", [](const Parts& p) { return p.f() / p.g * smith_g2(alpha, p.h, p.i); }},
};

}  // namespace oracle
