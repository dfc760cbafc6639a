#include "api.hpp"

#include <algorithm>

namespace exercise {

std::vector<double> cumulative(std::span<const double> weights) {
  std::vector<double> sums{0.0};
  for (const double weight : weights)
    sums.push_back(sums.back() + weight);

  // Divided last: the total by itself is 1, without rounding. Empty bins at the end have the total
  // as well, and so no share at all.
  const double total = sums.back();
  for (double& sum : sums)
    sum /= total;
  return sums;
}

int find_bin(std::span<const double> cdf, double u) {
  // The first number above u ends the bin. An empty bin ends where it begins, so that none of its
  // edges is the first above anything.
  return static_cast<int>(std::upper_bound(cdf.begin(), cdf.end(), u) - cdf.begin()) - 1;
}

double sample(std::span<const double> cdf, double u) {
  const int bins = static_cast<int>(cdf.size()) - 1;
  const int bin = find_bin(cdf, u);
  const double offset = (u - cdf[bin]) / (cdf[bin + 1] - cdf[bin]);
  // 1 / 49 * 49 is less than 1: right on an edge, rounding would put x into the neighbour.
  constexpr double margin = 0x1p-24;
  return (bin + std::clamp(offset, margin, 1.0 - margin)) / bins;
}

double pdf(std::span<const double> cdf, double x) {
  if (x < 0.0 || x >= 1.0) return 0.0;
  const int bins = static_cast<int>(cdf.size()) - 1;
  const int bin = static_cast<int>(x * bins);
  // A share of the samples, spread over a bin that is 1 / bins wide.
  return (cdf[bin + 1] - cdf[bin]) * bins;
}

namespace {

// The sum of each row: how likely a sample falls into it.
std::vector<double> row_sums(const Grid& grid) {
  std::vector<double> sums(grid.weights.size() / grid.columns);
  for (std::size_t i = 0; i < grid.weights.size(); ++i)
    sums[i / grid.columns] += grid.weights[i];
  return sums;
}

// The cumulative distribution within the row at y.
std::vector<double> cdf_of_row(const Grid& grid, double y) {
  const int rows = static_cast<int>(grid.weights.size()) / grid.columns;
  const int row = static_cast<int>(y * rows);
  const std::span all(grid.weights);
  return cumulative(all.subspan(row * grid.columns, grid.columns));
}

}  // namespace

glm::dvec2 sample(const Grid& grid, glm::dvec2 u) {
  const double y = sample(cumulative(row_sums(grid)), u.y);
  const double x = sample(cdf_of_row(grid, y), u.x);
  return {x, y};
}

double pdf(const Grid& grid, glm::dvec2 p) {
  // An empty row has no distribution within it: do not ask for one.
  const double row_density = pdf(cumulative(row_sums(grid)), p.y);
  if (row_density == 0.0) return 0.0;
  return row_density * pdf(cdf_of_row(grid, p.y), p.x);
}

}  // namespace exercise
