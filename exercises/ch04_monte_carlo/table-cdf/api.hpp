/// @file
/// Exercise 04.5: what you write and what the checker calls.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "common/testkit/not_written.hpp"

namespace exercise {

/// Sums of the first 0, 1, 2, ... weights, as shares of the total.
/// @param weights  of n equal bins of [0, 1); none negative, not all 0
/// @return n + 1 numbers, from exactly 0 to exactly 1; an empty bin leaves its number as it was
[[nodiscard]] std::vector<double> cumulative(std::span<const double> weights);

/// The bin that holds u: cdf[bin] <= u < cdf[bin + 1].
/// @param cdf  as from cumulative()
/// @param u    in [0, 1)
/// @return 0 to n - 1
[[nodiscard]] int find_bin(std::span<const double> cdf, double u);

/// The place in [0, 1) where the distribution reaches u. It rises evenly within a bin.
/// @return where pdf() is not 0, for any u in [0, 1)
[[nodiscard]] double sample(std::span<const double> cdf, double u);

/// The density with which sample() gives x, if u is uniform; 0 outside of [0, 1).
[[nodiscard]] double pdf(std::span<const double> cdf, double x);

/// Weights of equal cells that fill the square [0, 1) x [0, 1).
struct Grid {
  int columns;                  ///< cells in a row, side by side in x
  std::vector<double> weights;  ///< row by row, the rows one after the other in y; not all 0
};

/// A place in the square. A cell is as likely as its weight says, and so is all of it.
/// @param u  both in [0, 1)
/// @return where pdf() is not 0
[[nodiscard]] glm::dvec2 sample(const Grid& grid, glm::dvec2 u);

/// The density with which sample() gives p, if u is uniform; 0 outside of the square.
[[nodiscard]] double pdf(const Grid& grid, glm::dvec2 p);

}  // namespace exercise
