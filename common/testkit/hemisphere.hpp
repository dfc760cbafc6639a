/// @file
/// What the tests of exercises share that ask for directions of the upper hemisphere, z upwards.
/// All of it is here: the other exercises need not compile it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace lt {

/// A learner's sampler: from two numbers in [0, 1) to a direction.
using HemisphereSampler = glm::dvec3 (*)(glm::dvec2 u);

/// A density as a function of the direction's z, 1/sr.
using DensityOfZ = double (*)(double z);

/// Every u of an even grid on the unit square, and then of its rim.
[[nodiscard]] inline std::vector<glm::dvec2> places_on_square() {
  std::vector<double> one;
  for (int i = 0; i < 24; ++i)
    one.push_back((i + 0.5) / 24);
  one.insert(one.end(), {0.0, 1 - 0x1p-53});
  std::vector<glm::dvec2> all;
  for (const double x : one)
    for (const double y : one)
      all.emplace_back(x, y);
  return all;
}

/// "u = (0.25, 1 - 2^-53) gave (0, 1, 0)"
[[nodiscard]] inline std::string text_of_sample(HemisphereSampler sampler, glm::dvec2 u) {
  const glm::dvec3 w = sampler(u);
  return "u = (" + text_of_u(u.x) + ", " + text_of_u(u.y) + ") gave (" + text_of_u(w.x) + ", " +
         text_of_u(w.y) + ", " + text_of_u(w.z) + ')';
}

/// 100,000 directions; 20,000 for each of many seeds(), so that thousands need no minutes: a right
/// answer fails as rarely.
[[nodiscard]] inline std::vector<glm::dvec3> draw_directions(HemisphereSampler sampler,
                                                             std::uint64_t seed) {
  TestRandom random(seed);
  std::vector<glm::dvec3> all(seeds().size() == 1 ? 100'000 : 20'000);
  for (glm::dvec3& w : all) {
    const double x = random.uniform();
    const double y = random.uniform();
    w = sampler({x, y});
  }
  return all;
}

/// The mean of z.
[[nodiscard]] inline double mean_z(const std::vector<glm::dvec3>& directions) {
  RunningMean mean;
  for (const glm::dvec3& w : directions)
    mean.add(w.z);
  return mean.mean();
}

/// The angle around z from x towards y, in turns: 0 to 1.
[[nodiscard]] inline double turn(glm::dvec3 w) {
  const double part = std::atan2(w.y, w.x) / (2 * std::numbers::pi);
  return part < 0 ? part + 1 : part;
}

/// From a unit direction back to the unit square. Each of these spreads one distribution evenly:
/// the uniform one, the cosine-weighted one, and the one whose polar angle is uniform.
using Unfold = glm::dvec2 (*)(glm::dvec3 w);
[[nodiscard]] inline glm::dvec2 unfold_uniform(glm::dvec3 w) {
  return {w.z, turn(w)};
}
[[nodiscard]] inline glm::dvec2 unfold_cosine(glm::dvec3 w) {
  return {w.z * w.z, turn(w)};
}
[[nodiscard]] inline glm::dvec2 unfold_linear_theta(glm::dvec3 w) {
  return {std::acos(w.z) / (std::numbers::pi / 2), turn(w)};
}

inline constexpr int square_side = 16;  ///< of the unit square, in cells

/// How many fall in each cell of the square, one row after the other. At the end: how many fall
/// beside it.
[[nodiscard]] inline std::vector<double> counted(const std::vector<glm::dvec3>& directions,
                                                 Unfold unfold) {
  constexpr int side = square_side;
  std::vector<double> counts(side * side + 1);
  for (const glm::dvec3& w : directions) {
    const glm::dvec2 p = unfold(normalize(w));
    const bool is_inside = p.x > -1e-9 && p.x < 1 + 1e-9 && p.y > -1e-9 && p.y < 1 + 1e-9;
    const int row = is_inside ? std::clamp(static_cast<int>(p.x * side), 0, side - 1) : side;
    const int column = is_inside ? std::clamp(static_cast<int>(p.y * side), 0, side - 1) : 0;
    ++counts[static_cast<std::size_t>(row * side + column)];
  }
  return counts;
}

/// Chi-square of the unfolded directions in the cells; none is expected beside the square.
[[nodiscard]] inline ChiSquare evenness(const std::vector<glm::dvec3>& directions, Unfold unfold) {
  constexpr int cells = square_side * square_side;
  std::vector<double> expected(cells, static_cast<double>(directions.size()) / cells);
  expected.push_back(0);
  return chi_square(counted(directions, unfold), expected);
}

/// Whether the unfolded directions lie as evenly as chance allows.
[[nodiscard]] inline bool is_spread_evenly(const std::vector<glm::dvec3>& directions,
                                           Unfold unfold) {
  return evenness(directions, unfold).p_value >= 1e-6;
}

/// "z 0 to 0.0625, phi 180 to 202"
/// @param index  of a cell
/// @param z_at   z of a direction that unfolds to this height of the square
[[nodiscard]] inline std::string text_of_cell(std::ptrdiff_t index, double (*z_at)(double height)) {
  const double from = z_at(static_cast<double>(index / square_side) / square_side);
  const double to = z_at(static_cast<double>(index / square_side + 1) / square_side);
  const double phi = 360.0 * static_cast<double>(index % square_side) / square_side;
  std::ostringstream text;
  text.precision(3);
  text << "z " << from << " to " << to << ", phi " << phi << " to " << phi + 360.0 / square_side;
  return text.str();
}

/// What a person can see of an uneven distribution: the emptiest and the fullest cell.
/// @param z_at  z of a direction that unfolds to this height of the square
[[nodiscard]] inline std::string text_of_unevenness(const std::vector<glm::dvec3>& directions,
                                                    Unfold unfold, double (*z_at)(double height)) {
  std::vector<double> counts = counted(directions, unfold);
  counts.pop_back();
  const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
  std::ostringstream text;
  text << "256 cells should hold about " << directions.size() / 256
       << " directions each. The emptiest (" << text_of_cell(least - counts.begin(), z_at)
       << " degrees) holds " << *least << ", the fullest ("
       << text_of_cell(most - counts.begin(), z_at) << ") " << *most << ".";
  return text.str();
}

/// Whether the angle around z is 360 times one of the numbers, taken as radians: 57.3 turns, which
/// no count of cells would show.
[[nodiscard]] inline bool is_turned_in_degrees(HemisphereSampler sampler) {
  int first = 0;
  int second = 0;
  for (const glm::dvec2 u :
       {glm::dvec2(0.21, 0.83), glm::dvec2(0.47, 0.39), glm::dvec2(0.68, 0.14)}) {
    const double phi = 2 * std::numbers::pi * turn(sampler(u));
    first += std::cos(phi - 360 * u.x) > 1 - 1e-6;
    second += std::cos(phi - 360 * u.y) > 1 - 1e-6;
  }
  return first == 3 || second == 3;
}

/// Whether two densities are the same above the horizon, to 1e-6.
[[nodiscard]] inline bool is_same_density(DensityOfZ a, DensityOfZ b) {
  for (const double z : {0.2, 0.5, 0.9})
    if (!(std::abs(a(z) - b(z)) < 1e-6)) return false;  // nor is NaN
  return true;
}

}  // namespace lt
