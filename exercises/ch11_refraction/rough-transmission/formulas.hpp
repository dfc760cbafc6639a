/// @file
/// What the checker of exercise 11.3 compares with: the right formulas, and how many directions
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

inline double square(double x) {
  return x * x;
}

// Walter and others 2007, eq. 16.
inline glm::dvec3 right_h(glm::dvec3 wo, glm::dvec3 wi, double n_here, double n_beyond) {
  const glm::dvec3 h = normalize(-(n_here * wo + n_beyond * wi));
  return h.z < 0 ? -h : h;
}

// All that formulas are made of. Cosines to h (co, ci) and to the normal (mo, mi) are
// positive here.
struct Parts {
  double nh, nb, co, ci, mo, mi, d, g1, g2, through, through_flat;
  double sum = std::abs(nh * co - nb * ci);
};
inline std::optional<Parts> parts_of(const RoughGlass& glass, glm::dvec3 wo, glm::dvec3 wi) {
  const double nh = glass.n_here, nb = glass.n_beyond;
  const glm::dvec3 h = right_h(wo, wi, nh, nb);
  if (wi.z >= 0 || dot(wo, h) <= 0 || dot(wi, h) >= 0) return std::nullopt;
  Parts p{nh, nb, dot(wo, h), -dot(wi, h), wo.z, -wi.z, glass.ggx.d(h), 0, 0, 0, 0};
  p.g1 = 1 / (1 + glass.ggx.lambda(wo));
  p.g2 = p.g1 / (1 + glass.ggx.lambda(wi));
  p.through = 1 - fresnel_dielectric(p.co, nh, nb);
  p.through_flat = 1 - fresnel_dielectric(p.mo, nh, nb);
  return p;
}
using P = const Parts&;

// Walter and others: eq. 21, for radiance; eq. 17; their quotient.
inline double right_eval(P p) {
  return p.co * p.ci / (p.mo * p.mi) * square(p.nh / p.sum) * p.through * p.d * p.g2;
}
inline double facet_pdf(P p) {
  return p.g1 * p.co * p.d / p.mo;
}
inline double right_pdf(P p) {
  return facet_pdf(p) * p.ci * square(p.nb / p.sum);
}
inline double right_weight(P p) {
  return p.through * square(p.nh / p.nb) * p.g2 / p.g1;
}
// Of the cosines' sizes, as if both were positive.
inline double wrong_sum(P p) {
  return square(p.sum / (p.nh * p.co + p.nb * p.ci));
}

using Formula = double (*)(P p);

// Of directions below, in rows of equal height; then of those above; then of what leads nowhere.
inline constexpr int rows = 16, columns = 24, fine = 5;
inline std::vector<double> expected_shares(const RoughGlass& glass, glm::dvec3 wo) {
  std::vector<double> shares(rows * columns, 1e-9);  // a bin at the edge may have no fine point
  shares.resize(rows * columns + 2);
  for (int i = 0; i < rows * fine; ++i)
    for (int k = 0; k < columns * fine; ++k) {
      const double z = -(i + 0.5) / (rows * fine), phi = 2 * pi * (k + 0.5) / (columns * fine);
      const double radius = std::sqrt(1 - z * z);
      const auto parts = parts_of(glass, wo, {radius * std::cos(phi), radius * std::sin(phi), z});
      if (!parts) continue;
      shares[static_cast<std::size_t>(i / fine * columns + k / fine)] +=
          2 * pi / (rows * fine * columns * fine) * right_pdf(*parts);
    }
  // Into the denser medium every facet bends the ray down.
  if (glass.n_here > glass.n_beyond)
    shares.back() = 1 - std::accumulate(shares.begin(), shares.end(), 0.0);
  return shares;
}
inline std::size_t bin_of(const std::optional<BsdfSample>& made) {
  if (!made) return rows * columns + 1;
  if (!(made->wi.z < 0) || std::isnan(made->wi.x + made->wi.y)) return rows * columns;
  const double turn = std::atan2(made->wi.y, made->wi.x) / (2 * pi) + 1;
  const int row = std::min(rows - 1, static_cast<int>(-made->wi.z * rows));
  return static_cast<std::size_t>(row * columns + static_cast<int>(turn * columns) % columns);
}

// The bin that is farthest off, in words.
inline std::string worst(const RoughGlass& glass, glm::dvec3 wo, const std::vector<double>& counts,
                         const std::vector<double>& expected) {
  std::size_t most = 0;
  const auto off = [&](std::size_t i) {
    return square(counts[i] - expected[i]) / (expected[i] + 1);
  };
  for (std::size_t i = 0; i < counts.size(); ++i)
    most = off(i) > off(most) ? i : most;
  std::ostringstream text;
  text << "From index " << glass.n_here << " to " << glass.n_beyond << ", with wo " << text_of(wo)
       << ", ";
  if (most == rows * columns + 1) text << "of all samples those that lead nowhere";
  if (most == rows * columns) text << "of all samples those that point up";
  if (most < rows * columns)
    text << "samples with z about " << -(static_cast<double>(most / columns) + 0.5) / rows
         << " and phi about " << (static_cast<double>(most % columns) + 0.5) * 360 / columns
         << " degrees";
  text << " number " << counts[most] << " and should number about " << expected[most] << '.';
  return text.str();
}

}  // namespace oracle
