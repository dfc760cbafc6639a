/// @file
/// What the checker of exercise 08.1 compares with: D in double arithmetic, and what each mistake
/// makes of it.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "api.hpp"

namespace oracle {

using glm::dvec2;
using glm::vec3;
using std::numbers::pi;

inline double square(double x) {
  return x * x;
}

inline bool is_near(double value, double right, double relative = 1e-4) {
  return std::abs(value - right) <= relative * std::abs(right);  // false for NaN
}

// Walter and others 2007, eq. 33, in double, with the tangent along each axis measured by itself.
inline double expected(dvec2 alphas, vec3 h) {
  const glm::dvec3 n(h);
  if (n.z <= 0) return 0;
  const double squared = square(n.x / n.z / alphas.x) + square(n.y / n.z / alphas.y);
  return 1 / (pi * alphas.x * alphas.y * std::pow(n.z, 4) * square(1 + squared));
}
inline double expected(double alpha, vec3 h) {
  return expected(dvec2(alpha), h);
}

// The bracket with the cosines multiplied in.
inline double bracket(double a, vec3 h) {
  return h.x * h.x + h.y * h.y + square(a * h.z);
}

using Formula = double (*)(double alpha, vec3 h);
inline const std::vector<std::pair<const char*, Formula>> mistakes{
    {"alpha-squared-twice", [](double a, vec3 h) { return expected(a * a, h); }},
    {"alpha-not-squared", [](double a, vec3 h) { return expected(std::sqrt(a), h); }},
    {"alpha-once-above", [](double a, vec3 h) { return expected(a, h) / a; }},
    {"alpha-squared-inside", [](double a, vec3 h) { return expected(a, h) * a * a; }},
    {"pi-forgotten", [](double a, vec3 h) { return expected(a, h) * pi; }},
    {"cos4-forgotten", [](double a, vec3 h) { return expected(a, h) * std::pow(h.z, 4); }},
    {"cos2-for-cos4", [](double a, vec3 h) { return expected(a, h) * h.z * h.z; }},
    {"cosine-included", [](double a, vec3 h) { return expected(a, h) * h.z; }},
    {"tan-not-squared",
     [](double a, vec3 h) {
       const double tan = std::sqrt(1.0 - h.z * h.z) / h.z;
       return a * a / (pi * std::pow(h.z, 4) * square(a * a + tan));
     }},
    {"sine-for-tangent",
     [](double a, vec3 h) {
       return a * a / (pi * std::pow(h.z, 4) * square(a * a + 1.0 - h.z * h.z));
     }},
    {"alpha-without-cosine",
     [](double a, vec3 h) { return square(a / (h.x * h.x + h.y * h.y + a * a)) / pi; }},
    {"bracket-not-squared",
     [](double a, vec3 h) { return expected(a, h) * bracket(a, h) / (h.z * h.z); }},
    {"quotient-not-squared", [](double a, vec3 h) { return a / bracket(a, h) / pi; }},
    {"multiplied-not-divided", [](double a, vec3 h) { return square(a * bracket(a, h)) / pi; }},
    {"multiplied-not-divided",
     [](double a, vec3 h) { return square(a * bracket(a, h) / std::pow(h.z, 4)) / pi; }},
    {"normal-along-y", [](double a, vec3 h) { return expected(a, vec3(h.x, h.z, h.y)); }},
};

using Brushed = double (*)(dvec2 alphas, vec3 h);
// The bracket of the brushed surface, cosines multiplied in; `one` is what the 1 has become.
inline double brushed_bracket(dvec2 a, vec3 h, double one) {
  return square(h.x / a.x) + square(h.y / a.y) + one;
}
inline const std::vector<std::pair<const char*, Brushed>> brushed_mistakes{
    {"one-alpha-in-front", [](dvec2 a, vec3 h) { return expected(a, h) * a.y / a.x; }},
    {"axes-swapped",
     [](dvec2 a, vec3 h) {
       return expected({a.y, a.x}, h);
     }},
    {"widths-not-squared",
     [](dvec2 a, vec3 h) { return expected(glm::sqrt(a), h) / std::sqrt(a.x * a.y); }},
    {"one-mean-width", [](dvec2 a, vec3 h) { return expected(std::sqrt(a.x * a.y), h); }},
    {"one-mean-width", [](dvec2 a, vec3 h) { return expected((a.x + a.y) / 2, h); }},
    {"one-without-cosine",
     [](dvec2 a, vec3 h) { return 1 / (pi * a.x * a.y * square(brushed_bracket(a, h, 1))); }},
    {"widths-above", [](dvec2 a, vec3 h) { return expected(a, h) * square(a.x * a.y); }},
    // Those of the round one, made here.
    {"pi-forgotten", [](dvec2 a, vec3 h) { return expected(a, h) * pi; }},
    {"cos4-forgotten", [](dvec2 a, vec3 h) { return expected(a, h) * std::pow(h.z, 4); }},
    {"cos2-for-cos4", [](dvec2 a, vec3 h) { return expected(a, h) * h.z * h.z; }},
    {"cosine-included", [](dvec2 a, vec3 h) { return expected(a, h) * h.z; }},
    {"bracket-not-squared",
     [](dvec2 a, vec3 h) {
       return expected(a, h) * brushed_bracket(a, h, h.z * h.z) / (h.z * h.z);
     }},
};

}  // namespace oracle
