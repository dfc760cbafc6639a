/// @file
/// What the checker of exercise 10.1 compares with: the right formulas, and how many directions
/// fall where.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "api.hpp"
#include "common/testkit/exercise.hpp"

namespace oracle {

using namespace exercise;
using lt::text_of;
using std::numbers::pi;

inline const CoatedBase red{0.75, 0.4, 1.5};

// All that formulas are made of: coat and base as BSDFs and as densities, p for the coat.
struct Parts {
  double coat, base, coat_pdf, base_pdf, p, in, out, at_facet, mo, mi;
};
inline Parts parts_of(glm::dvec3 wo, glm::dvec3 wi) {
  const double facet = fresnel(red, std::min(1.0, dot(wo, normalize(wo + wi))));
  return {coat_eval(red, wo, wi),
          red.tint / pi,
          coat_pdf(red, wo, wi),
          wi.z / pi,
          coat_probability(red, wo),
          1 - fresnel(red, wi.z),
          1 - fresnel(red, wo.z),
          1 - facet,
          wo.z,
          wi.z};
}
using P = const Parts&;
inline double right_eval(P p) {
  return p.coat + p.base * p.in * p.out;
}
inline double right_pdf(P p) {
  return p.p * p.coat_pdf + (1 - p.p) * p.base_pdf;
}
inline double right_weight(P p) {
  return right_eval(p) * p.mi / right_pdf(p);
}

using Formula = double (*)(P p);

// Directions above in rows of equal height; then those below; then what leads nowhere.
inline constexpr int rows = 16, columns = 24, fine = 5;
inline std::vector<double> expected_shares(glm::dvec3 wo) {
  std::vector<double> shares(rows * columns + 2);
  double coat = 0;  // of it, what points up
  for (int i = 0; i < rows * fine; ++i)
    for (int k = 0; k < columns * fine; ++k) {
      const double z = (i + 0.5) / (rows * fine), phi = 2 * pi * (k + 0.5) / (columns * fine);
      const double radius = std::sqrt(1 - z * z);
      const Parts parts = parts_of(wo, {radius * std::cos(phi), radius * std::sin(phi), z});
      const double area = 2 * pi / (rows * fine * columns * fine);
      shares[static_cast<std::size_t>(i / fine * columns + k / fine)] += area * right_pdf(parts);
      coat += area * parts.coat_pdf;
    }
  shares.back() = coat_probability(red, wo) * (1 - coat);
  return shares;
}
inline std::size_t bin_of(const std::optional<BsdfSample>& made) {
  if (!made) return rows * columns + 1;
  if (!(made->wi.z >= 0) || std::isnan(made->wi.x + made->wi.y)) return rows * columns;
  const double turn = std::atan2(made->wi.y, made->wi.x) / (2 * pi) + 1;
  const int row = std::min(rows - 1, static_cast<int>(made->wi.z * rows));
  return static_cast<std::size_t>(row * columns + static_cast<int>(turn * columns) % columns);
}
// The bin that is farthest off, in words.
inline std::string worst(glm::dvec3 wo, const std::vector<double>& counts,
                         const std::vector<double>& expected) {
  const auto off = [&](std::size_t i) {
    return std::abs(counts[i] - expected[i]) / std::sqrt(expected[i] + 1);
  };
  std::size_t most = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    most = off(i) > off(most) ? i : most;
  std::ostringstream text;
  text << "With the cosine of wo " << wo.z << ", ";
  if (most == rows * columns + 1) text << "of all samples those that lead nowhere";
  if (most == rows * columns) text << "of all samples those that point down";
  if (most < rows * columns)
    text << "samples with z about " << (static_cast<double>(most / columns) + 0.5) / rows
         << " and phi about " << (static_cast<double>(most % columns) + 0.5) * 360 / columns
         << " degrees";
  text << " number " << counts[most] << " and should number about " << expected[most] << '.';
  return text.str();
}

}  // namespace oracle
