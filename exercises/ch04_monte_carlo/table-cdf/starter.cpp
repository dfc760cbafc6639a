#include "api.hpp"

#include <algorithm>

namespace exercise {

std::vector<double> cumulative(std::span<const double> /*weights*/) {
  TODO("add up the weights, from 0 to the total, and make shares of the sums");
}

int find_bin(std::span<const double> /*cdf*/, double /*u*/) {
  TODO("find the bin that begins at or below u and ends above it");
}

double sample(std::span<const double> /*cdf*/, double /*u*/) {
  TODO("find the bin, then the place in it");
}

double pdf(std::span<const double> /*cdf*/, double /*x*/) {
  TODO("turn the share of the bin at x into a density");
}

glm::dvec2 sample(const Grid& /*grid*/, glm::dvec2 /*u*/) {
  TODO("choose a row, then a place in it");
}

double pdf(const Grid& /*grid*/, glm::dvec2 /*p*/) {
  TODO("combine the density of the row and that of the place in it");
}

}  // namespace exercise
