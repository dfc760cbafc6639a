/// @file
/// Densities given as numbers: a histogram, a picture.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "ch04_monte_carlo/estimator.hpp"

namespace lt {

// [cumulative]
/// Sums of the first 0, 1, 2, ... weights as shares of the total: from 0 to exactly 1.
/// @param weights  >= 0
/// @return all 0 if all weights are
[[nodiscard]] inline std::vector<double> cumulative(std::span<const double> weights) {
  std::vector<double> cdf{0};
  for (const double weight : weights) {
    assert(weight >= 0);
    cdf.push_back(cdf.back() + weight);
  }
  const double total = cdf.back();
  if (total == 0) return cdf;
  for (double& share : cdf)
    share /= total;  // total / total is 1, without rounding
  return cdf;
}
// [cumulative]

// [find-bin]
/// The bin that holds u: the last that begins at or below it. Where an empty bin begins, another
/// one begins too, behind it: an empty one is never the last.
/// @param cdf  from cumulative(), not all 0
/// @param u    in [0, 1)
[[nodiscard]] inline int find_bin(std::span<const double> cdf, double u) {
  assert(cdf.back() == 1 && u >= 0 && u < 1);
  return static_cast<int>(std::upper_bound(cdf.begin(), cdf.end(), u) - cdf.begin()) - 1;
}
// [find-bin]

// [tabulated-density]
/// A density over [0, 1) that is constant in each of n equal bins.
class TabulatedDensity {
 public:
  /// @param weights  >= 0, one a bin, at most 2^25; without a positive one there is no sample()
  explicit TabulatedDensity(std::span<const double> weights) : cdf_(cumulative(weights)) {}

  [[nodiscard]] int bins() const { return static_cast<int>(cdf_.size()) - 1; }
  [[nodiscard]] int bin_at(double x) const { return static_cast<int>(x * bins()); }

  /// The share of samples that fall into a bin.
  [[nodiscard]] double probability(int bin) const { return cdf_[bin + 1] - cdf_[bin]; }

  // [table-sample]
  /// @param u  in [0, 1)
  /// @return in a bin that is not empty, and not on its edges
  [[nodiscard]] double sample(double u) const {
    constexpr double margin = 0x1p-24;  // or rounding may push x into a neighbour: 1/49 * 49 < 1
    const int bin = find_bin(cdf_, u);
    const double offset = (u - cdf_[bin]) / probability(bin);
    return (bin + std::clamp(offset, margin, 1 - margin)) / bins();
  }
  // [table-sample]

  [[nodiscard]] double pdf(double x) const {
    return x >= 0 && x < 1 ? probability(bin_at(x)) * bins() : 0;
  }

  [[nodiscard]] double cdf(double x) const {
    if (x < 0) return 0;
    if (x >= 1) return 1;
    const int bin = bin_at(x);
    return cdf_[bin] + (x * bins() - bin) * probability(bin);
  }

 private:
  std::vector<double> cdf_;
};
// [tabulated-density]

static_assert(Density<TabulatedDensity>);

// [tabulated-density-2d]
/// A density over [0, 1) x [0, 1) that is constant in each cell of a table: first choose a row,
/// then a place in it.
class TabulatedDensity2D {
 public:
  /// @param weights  >= 0, row by row, not all 0
  /// @param columns  numbers in a row, >= 1
  TabulatedDensity2D(std::span<const double> weights, int columns)
      : rows_(row_sums(weights, columns)) {
    for (std::size_t i = 0; i < weights.size(); i += columns)
      within_.emplace_back(weights.subspan(i, columns));
  }

  /// @param u  each in [0, 1)
  /// @return x along a row, y from row to row
  [[nodiscard]] glm::dvec2 sample(glm::dvec2 u) const {
    const double y = rows_.sample(u.y);
    return {row_at(y).sample(u.x), y};
  }

  [[nodiscard]] double pdf(glm::dvec2 p) const {
    const double row_density = rows_.pdf(p.y);
    return row_density == 0 ? 0 : row_density * row_at(p.y).pdf(p.x);
  }

 private:
  [[nodiscard]] const TabulatedDensity& row_at(double y) const { return within_[rows_.bin_at(y)]; }

  [[nodiscard]] static std::vector<double> row_sums(std::span<const double> weights, int columns) {
    assert(columns >= 1 && weights.size() % columns == 0);
    std::vector<double> sums(weights.size() / columns);
    for (std::size_t i = 0; i < weights.size(); ++i)
      sums[i / columns] += weights[i];
    return sums;
  }

  TabulatedDensity rows_;
  std::vector<TabulatedDensity> within_;  // one for each row
};
// [tabulated-density-2d]

}  // namespace lt
