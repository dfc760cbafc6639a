// Nothing is searched: the bins are gone through one by one, from the back. In the plane there is
// one long row, all cells one after the other; what is left of u.x within its cell is used again.
// The density of a cell is its weight over the mean weight.
#include "api.hpp"

#include <cmath>
#include <numeric>

namespace exercise {

namespace {

// Where in its bin u lies, from 0 to 1 but for a hair at both ends.
double place_in_bin(std::span<const double> cdf, int bin, double u) {
  const double place = (u - cdf[bin]) / (cdf[bin + 1] - cdf[bin]);
  return 1e-9 + (1.0 - 2e-9) * place;
}

}  // namespace

std::vector<double> cumulative(std::span<const double> weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<double> cdf(weights.size() + 1, 0.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
    cdf[i + 1] = (sum += weights[i]) / total;
  return cdf;
}

int find_bin(std::span<const double> cdf, double u) {
  int bin = static_cast<int>(cdf.size()) - 2;
  while (cdf[bin] > u || cdf[bin] == cdf[bin + 1])
    --bin;
  return bin;
}

double sample(std::span<const double> cdf, double u) {
  const int bin = find_bin(cdf, u);
  return (bin + place_in_bin(cdf, bin, u)) / static_cast<double>(cdf.size() - 1);
}

double pdf(std::span<const double> cdf, double x) {
  const double bins = static_cast<double>(cdf.size() - 1);
  const double bin = std::floor(x * bins);
  if (!(bin >= 0.0 && bin < bins)) return 0.0;
  const auto i = static_cast<std::size_t>(bin);
  return (cdf[i + 1] - cdf[i]) / (1.0 / bins);
}

glm::dvec2 sample(const Grid& grid, glm::dvec2 u) {
  const std::vector<double> cdf = cumulative(grid.weights);
  const int rows = static_cast<int>(grid.weights.size()) / grid.columns;
  const int cell = find_bin(cdf, u.x);
  return {(cell % grid.columns + place_in_bin(cdf, cell, u.x)) / grid.columns,
          (cell / grid.columns + 1e-9 + (1.0 - 2e-9) * u.y) / rows};
}

double pdf(const Grid& grid, glm::dvec2 p) {
  if (p.x < 0.0 || p.x >= 1.0 || p.y < 0.0 || p.y >= 1.0) return 0.0;
  const double total = std::accumulate(grid.weights.begin(), grid.weights.end(), 0.0);
  const double cells = static_cast<double>(grid.weights.size());
  const int row = static_cast<int>(p.y * (cells / grid.columns));
  const int column = static_cast<int>(p.x * grid.columns);
  return grid.weights[row * grid.columns + column] * cells / total;
}

}  // namespace exercise
