/// @file
/// What the checker of exercise 08.2 compares with: Smith's masking, and what each mistake makes of
/// it.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "api.hpp"

namespace oracle {

using glm::dvec3;

inline double tan(dvec3 w) {
  return std::hypot(w.x, w.y) / std::abs(w.z);
}
inline double half_root(double x) {
  return (std::sqrt(1 + x) - 1) / 2;
}

// Walter and others 2007, eq. 34, is 1 / (1 + Lambda); Heitz 2014, eq. 99, for both directions.
inline double right_lambda(double alpha, dvec3 w) {
  return half_root(alpha * alpha * tan(w) * tan(w));
}
inline double seen_share(double alpha, dvec3 w) {
  return 1 / (1 + right_lambda(alpha, w));
}
inline double smaller(double alpha, dvec3 wo, dvec3 wi) {
  return std::min(seen_share(alpha, wo), seen_share(alpha, wi));
}
inline double right_g1(double alpha, dvec3 w, dvec3 h) {
  return dot(w, h) * w.z > 0 ? seen_share(alpha, w) : 0;
}
inline double right_g2(double alpha, dvec3 wo, dvec3 wi) {
  return wo.z * wi.z > 0 ? 1 / (1 + right_lambda(alpha, wo) + right_lambda(alpha, wi)) : 0;
}

inline bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-5 * std::max(1.0, std::abs(b));  // false for NaN
}

using Lambda = double (*)(double alpha, dvec3 w);
inline const std::vector<std::pair<const char*, Lambda>> lambda_mistakes{
    {"half-forgotten", [](double a, dvec3 w) { return 2 * right_lambda(a, w); }},
    {"one-not-subtracted", [](double a, dvec3 w) { return right_lambda(a, w) + 0.5; }},
    {"one-outside", [](double a, dvec3 w) { return right_lambda(a, w) - 0.5; }},
    {"one-added", [](double a, dvec3 w) { return right_lambda(a, w) + 1; }},
    {"one-inside", [](double a, dvec3 w) { return a * tan(w) / 2; }},
    {"root-forgotten", [](double a, dvec3 w) { return std::pow(a * tan(w), 2) / 2; }},
    {"tan-not-squared", [](double a, dvec3 w) { return half_root(a * a * tan(w)); }},
    {"alpha-not-squared", [](double a, dvec3 w) { return right_lambda(std::sqrt(a), w); }},
    {"alpha-squared-twice", [](double a, dvec3 w) { return right_lambda(a * a, w); }},
    {"sine-for-tangent", [](double a, dvec3 w) { return half_root(a * a * (1 - w.z * w.z)); }},
    {"tangent-inverted", [](double a, dvec3 w) { return half_root(std::pow(a * tan(w), -2)); }},
};

inline double schlick(dvec3 w, double k) {
  return w.z / (w.z * (1 - k) + k);
}

using Pair = double (*)(double alpha, dvec3 a, dvec3 b);
inline const std::vector<std::pair<const char*, Pair>> g1_mistakes{
    {"g-uses-n-dot-h", [](double a, dvec3, dvec3 h) { return seen_share(a, h); }},
    {"g-uses-w-dot-h",
     [](double a, dvec3 w, dvec3 h) {
       return seen_share(a, {length(cross(w, h)), 0, dot(w, h)});
     }},
    {"hidden-for-seen", [](double a, dvec3 w, dvec3) { return 1 - seen_share(a, w); }},
    {"one-minus-lambda", [](double a, dvec3 w, dvec3) { return 1 - right_lambda(a, w); }},
    {"schlicks-fit", [](double a, dvec3 w, dvec3) { return schlick(w, a / 2); }},
    {"schlicks-fit", [](double a, dvec3 w, dvec3) { return schlick(w, (a + 1) * (a + 1) / 8); }},
    {"beckmanns-masking",
     [](double alpha, dvec3 w, dvec3) {
       const double a = 1 / (alpha * tan(w));
       return a < 1.6 ? (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a) : 1.0;
     }},
};
inline const std::vector<std::pair<const char*, Pair>> g2_mistakes{
    {"separable", [](double a, dvec3 o, dvec3 i) { return seen_share(a, o) * seen_share(a, i); }},
    {"g1-only", [](double a, dvec3 o, dvec3) { return seen_share(a, o); }},
    {"g1-only", [](double a, dvec3, dvec3 i) { return seen_share(a, i); }},
    {"smaller-of-both", smaller},
    {"one-twice", [](double a, dvec3 o, dvec3 i) { return 1 / (1 / right_g2(a, o, i) + 1); }},
    {"one-minus-lambda",
     [](double a, dvec3 o, dvec3 i) { return 1 - right_lambda(a, o) - right_lambda(a, i); }},
    {"denominator-included",
     [](double a, dvec3 o, dvec3 i) { return right_g2(a, o, i) / (4 * o.z * i.z); }},
};

}  // namespace oracle
