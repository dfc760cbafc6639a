/// @file
/// What the checker of exercise 09.3 compares with: the right density, and how many normals fall
/// where.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
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

}  // namespace oracle
