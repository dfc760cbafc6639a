/// @file
/// What the checker of exercise 09.3 compares with: right and wrong densities, samplers and
/// weights, and how many normals fall where.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "api.hpp"
#include "common/testkit/statistics.hpp"

namespace oracle {

using namespace exercise;
using glm::dvec2, glm::dvec3;
using std::numbers::pi;

inline const double alpha = 0.4;
inline const dvec3 low{-0.48, 0.8, 0.36}, flat{0.96, 0, 0.28}, above{0, 0, 1};

// The density that Heitz and d'Eon 2014 found, of all that comes into it.
struct Facet {
  dvec3 o, h;
  double a = alpha, cosine = dot(o, h), d = ggx_d(a, h), g = smith_g1(a, o);
  [[nodiscard]] double pdf() const { return g * d * std::max(0.0, cosine) / o.z; }
};

// Normals in 16 heights times 16 turns; those that face down have the last cell.
inline constexpr int rows = 16, columns = 16, fine = 16;
inline std::vector<double> counts_of(const std::vector<dvec3>& normals) {
  std::vector<double> counts(rows * columns + 1);
  for (const dvec3& h : normals) {
    const double turn = std::atan2(-h.y, -h.x) / (2 * pi) + 0.5;
    const bool is_up = h.z > 0 && h.z < 2 && !std::isnan(turn);
    const int row = is_up ? std::min(rows - 1, static_cast<int>(h.z * rows)) : rows;
    const int column = is_up ? std::min(columns - 1, static_cast<int>(turn * columns)) : 0;
    ++counts[static_cast<std::size_t>(row * columns + column)];
  }
  return counts;
}
// How many of `count` each cell should have, by the density, and the normals' mean.
struct Expected {
  std::vector<double> counts = std::vector<double>(rows * columns, 1e-9);  // an edge may cut a cell
  dvec3 mean{0};
};
inline Expected expected_of(double a, dvec3 wo, double count) {
  Expected result;
  for (int k = 0; k < rows * columns * fine * fine; ++k) {
    const int row = k / (columns * fine), column = k % (columns * fine);
    const double z = (row + 0.5) / (rows * fine);
    const double phi = 2 * pi * (column + 0.5) / (columns * fine);
    const dvec3 h(std::sqrt(1 - z * z) * dvec2(std::cos(phi), std::sin(phi)), z);
    const double share = Facet{wo, h, a}.pdf() * 2 * pi / (rows * fine * columns * fine);
    result.counts[static_cast<std::size_t>(row / fine * columns + column / fine)] += count * share;
    result.mean += share * h;
  }
  result.counts.push_back(0);
  return result;
}
inline bool fits(const std::vector<double>& counts, const std::vector<double>& expected) {
  return lt::chi_square(counts, expected).p_value > 1e-6;
}

// The parts of a sampler, right ones first.
inline dvec3 stretched(dvec3 v, double a = alpha) {
  return normalize(dvec3(a * v.x, a * v.y, v.z));
}
inline dvec3 at_height(double z, double turn) {
  return {
      std::sqrt(std::max(0.0, 1 - z * z)) * dvec2(std::cos(2 * pi * turn), std::sin(2 * pi * turn)),
      z};
}
// Dupuy and Benyoub 2023: even over the cap above -v.z.
inline dvec3 cap(dvec3 v, dvec2 u) {
  return at_height((1 - u.y) * (1 + v.z) - v.z, u.x);
}
// Heitz 2018: the ball's normal at a place of its picture, and one axis of the picture.
inline dvec3 on_ball(dvec3 v, dvec3 level, double a, double b) {
  return a * level + b * cross(v, level) + std::sqrt(std::max(0.0, 1 - a * a - b * b)) * v;
}
inline dvec3 level_of(dvec3 v) {
  return normalize(dvec3(-v.y, v.x, 0));
}
inline dvec2 disk(double radius, double turn) {
  return radius * dvec2(std::cos(2 * pi * turn), std::sin(2 * pi * turn));
}
inline double squeezed(dvec2 t, double share) {
  return (1 - share) * std::sqrt(1 - t.x * t.x) + share * t.y;
}
inline dvec3 by_disk(dvec3 v, dvec2 t) {
  return stretched(on_ball(v, level_of(v), t.x, squeezed(t, (1 + v.z) / 2)));
}

// Where a mistaken sampler looks: `o` is wo, `v` the view, stretched as it should be.
using Sampler = dvec3 (*)(dvec3 o, dvec3 v, dvec2 u);
inline const std::vector<std::pair<const char*, Sampler>> mistakes{
    {"not-unstretched", [](dvec3, dvec3 v, dvec2 u) { return normalize(cap(v, u) + v); }},
    {"not-stretched", [](dvec3 o, dvec3, dvec2 u) { return stretched(cap(o, u) + o); }},
    {"alpha-ignored", [](dvec3 o, dvec3, dvec2 u) { return normalize(cap(o, u) + o); }},
    {"normals-as-points",
     [](dvec3, dvec3 v, dvec2 u) { return stretched(cap(v, u) + v, 1 / alpha); }},
    {"view-flattened",
     [](dvec3 o, dvec3, dvec2 u) {
       const dvec3 v = stretched(o, 1 / alpha);
       return stretched(cap(v, u) + v);
     }},
    {"view-not-unit",
     [](dvec3 o, dvec3, dvec2 u) {
       const dvec3 v(alpha * o.x, alpha * o.y, o.z);
       return stretched(cap(v, u) + v);
     }},
    {"alpha-squared",
     [](dvec3 o, dvec3, dvec2 u) {
       const dvec3 v = stretched(o, alpha * alpha);
       return stretched(cap(v, u) + v, alpha * alpha);
     }},
    {"azimuth-forgotten",
     [](dvec3, dvec3 v, dvec2 u) {
       const dvec3 turned(std::hypot(v.x, v.y), 0, v.z);
       return stretched(cap(turned, u) + turned);
     }},
    {"wo-ignored", [](dvec3, dvec3, dvec2 u) { return stretched(at_height(std::sqrt(u.y), u.x)); }},
    {"backs-turned",
     [](dvec3 o, dvec3, dvec2 u) {
       const dvec3 h = stretched(at_height(std::sqrt(u.y), u.x));
       return dot(o, h) < 0 ? dvec3(-h.x, -h.y, h.z) : h;
     }},
    {"whole-ball",
     [](dvec3, dvec3 v, dvec2 u) { return stretched(at_height(1 - 2 * u.y, u.x) + v); }},
    {"half-sphere", [](dvec3, dvec3 v, dvec2 u) { return stretched(at_height(1 - u.y, u.x) + v); }},
    {"cap-sign",
     [](dvec3, dvec3 v, dvec2 u) {
       return stretched(at_height((1 - u.y) * (1 - v.z) + v.z, u.x) + v);
     }},
    {"not-half-way", [](dvec3, dvec3 v, dvec2 u) { return stretched(cap(v, u)); }},
    {"half-turn",
     [](dvec3, dvec3 v, dvec2 u) {
       return stretched(cap(v, {u.x / 2, u.y}) + v);
     }},
    {"half-turn",
     [](dvec3, dvec3 v, dvec2 u) { return by_disk(v, disk(std::sqrt(u.y), u.x / 2)); }},
    {"sine-not-rooted",
     [](dvec3, dvec3 v, dvec2 u) {
       const dvec3 w = cap(v, u);
       return stretched(dvec3(dvec2(w) * std::sqrt(1 - w.z * w.z), w.z) + v);
     }},
    {"squeezed-the-wrong-way",
     [](dvec3, dvec3 v, dvec2 u) {
       const dvec2 t = disk(std::sqrt(u.y), u.x);
       return stretched(on_ball(v, level_of(v), t.x, squeezed(t, (1 - v.z) / 2)));
     }},
    {"squeezed-by-wo",
     [](dvec3 o, dvec3 v, dvec2 u) {
       const dvec2 t = disk(std::sqrt(u.y), u.x);
       return stretched(on_ball(v, level_of(v), t.x, squeezed(t, (1 + o.z) / 2)));
     }},
    {"disk-radius-even", [](dvec3, dvec3 v, dvec2 u) { return by_disk(v, disk(u.y, u.x)); }},
    {"axes-not-unit",
     [](dvec3, dvec3 v, dvec2 u) {
       const dvec2 t = disk(std::sqrt(u.y), u.x);
       return stretched(on_ball(v, {-v.y, v.x, 0}, t.x, squeezed(t, (1 + v.z) / 2)));
     }},
};
// 100,000 normals of a mistaken sampler, without chance (Roberts 2018), in their cells.
inline std::vector<double> expected_of(Sampler sampler, double count) {
  std::vector<dvec3> normals(100'000);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const dvec2 u = fract(0.5 + static_cast<double>(i) * dvec2(0.7548776662, 0.5698402910));
    normals[i] = sampler(low, stretched(low), u);
  }
  std::vector<double> expected = counts_of(normals);
  for (double& number : expected)
    number = number * count / 100'000 + 1e-9;
  return expected;
}

using PdfMistake = double (*)(const Facet& f);
inline const std::vector<std::pair<const char*, PdfMistake>> pdf_mistakes{
    {"pdf-of-plain-d", [](const Facet& f) { return f.d * f.h.z; }},
    {"g1-forgotten", [](const Facet& f) { return f.pdf() / f.g; }},
    {"g1-of-h", [](const Facet& f) { return f.pdf() / f.g * smith_g1(alpha, f.h); }},
    {"not-normalised", [](const Facet& f) { return f.pdf() * f.o.z; }},
    {"facing-forgotten", [](const Facet& f) { return f.pdf() / f.cosine; }},
    {"cosine-of-h", [](const Facet& f) { return f.pdf() / f.cosine * f.h.z; }},
    {"divided-by-cosine-of-h", [](const Facet& f) { return f.pdf() * f.o.z / f.h.z; }},
    {"pdf-of-direction", [](const Facet& f) { return f.pdf() / (4 * f.cosine); }},
};
inline const std::array<std::pair<dvec3, dvec3>, 3> seen_facets{
    {{low, {0, 0.6, 0.8}}, {flat, {0.36, -0.48, 0.8}}, {{0.6, 0, 0.8}, {0.48, 0.64, 0.6}}}};

using WeightMistake = double (*)(dvec3 o, dvec3 i);
inline double right_weight(dvec3 o, dvec3 i) {
  return smith_g2(alpha, o, i) / smith_g1(alpha, o);
}
inline double cosine_at_facet(dvec3 o, dvec3 i) {
  return dot(o, normalize(o + i));
}
inline const std::vector<std::pair<const char*, WeightMistake>> weight_mistakes{
    {"weight-of-all-normals",
     [](dvec3 o, dvec3 i) {
       return smith_g2(alpha, o, i) * cosine_at_facet(o, i) / (o.z * normalize(o + i).z);
     }},
    {"seen-not-paid", [](dvec3 o, dvec3 i) { return smith_g2(alpha, o, i); }},
    {"g1-of-wi-below", [](dvec3 o, dvec3 i) { return right_weight(i, o); }},
    {"weight-separable", [](dvec3, dvec3 i) { return smith_g1(alpha, i); }},
    {"weight-upside-down", [](dvec3 o, dvec3 i) { return 1 / right_weight(o, i); }},
    {"weight-one", [](dvec3, dvec3) { return 1.0; }},
    {"weight-without-cosine", [](dvec3 o, dvec3 i) { return right_weight(o, i) / i.z; }},
    {"weight-by-facet-pdf",
     [](dvec3 o, dvec3 i) { return right_weight(o, i) / (4 * cosine_at_facet(o, i)); }},
};
inline const std::array<std::pair<dvec3, dvec3>, 3> lit_pairs{
    {{low, {0, -0.6, 0.8}}, {flat, {-0.48, 0.64, 0.6}}, {{0.6, 0, 0.8}, {-0.96, 0, 0.28}}}};

}  // namespace oracle
