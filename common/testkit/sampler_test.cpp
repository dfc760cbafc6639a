#include "common/testkit/sampler_test.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <numbers>
#include <sstream>

namespace lt {

namespace {

constexpr double exact_pi = std::numbers::pi;

// A part of a bin.
struct Cell {
  double z0, z1, phi0, phi1;
};

vec3 direction_at(double z, double phi) {
  const double radius = std::sqrt(std::max(0.0, (1 - z) * (1 + z)));
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

// Gauss' rule with 3 x 3 points: exact for polynomials of degree 5 in z and in phi.
double gauss(const DirectionFunction& f, const Cell& cell) {
  const double node = std::sqrt(0.6);
  const std::array<double, 3> nodes{-node, 0, node};
  const std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
  const double z_half = (cell.z1 - cell.z0) / 2;
  const double phi_half = (cell.phi1 - cell.phi0) / 2;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      sum +=
          weights[i] * weights[j] *
          f(direction_at(cell.z0 + z_half * (1 + nodes[i]), cell.phi0 + phi_half * (1 + nodes[j])));
  return sum * 4 * z_half * phi_half;  // d omega = dz dphi
}

std::array<Cell, 4> quarters(const Cell& cell) {
  const double z = (cell.z0 + cell.z1) / 2;
  const double phi = (cell.phi0 + cell.phi1) / 2;
  return {Cell{cell.z0, z, cell.phi0, phi}, Cell{cell.z0, z, phi, cell.phi1},
          Cell{z, cell.z1, cell.phi0, phi}, Cell{z, cell.z1, phi, cell.phi1}};
}

// Splits a cell as long as its parts say something else than the whole, at least once.
double integrate_cell(const DirectionFunction& f, const Cell& cell, double whole, double tolerance,
                      int depth = 0) {
  constexpr int deepest = 20;
  const std::array<Cell, 4> parts = quarters(cell);
  std::array<double, 4> integrals{};
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    integrals[i] = gauss(f, parts[i]);
    sum += integrals[i];
  }
  const bool is_settled = std::abs(sum - whole) <= std::max(tolerance, 1e-7 * std::abs(sum));
  if (std::isnan(sum) || (depth > 0 && is_settled) || depth == deepest) return sum;
  sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    sum += integrate_cell(f, parts[i], integrals[i], tolerance, depth + 1);
  return sum;
}

std::string text(vec3 v) {
  std::ostringstream out;
  out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return out.str();
}

bool is_finite_and_not_negative(vec3 v) {
  return std::min({v.x, v.y, v.z}) >= 0 && std::isfinite(v.x + v.y + v.z);
}

bool is_unit(vec3 v) {
  return std::abs(dot(v, v) - 1) < 1e-5f;
}

bool is_near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

std::string complaint_about(const SamplerReport& report) {
  std::ostringstream out;
  if (!(report.integral <= 1 + 1e-4)) {
    out << "the density integrates to " << report.integral << ", more than 1";
  } else if (!(report.chi_square.p_value > 1e-6)) {
    out << "the samples do not follow the density: chi-square " << report.chi_square.statistic
        << " with " << report.chi_square.degrees_of_freedom
        << " degrees of freedom, p = " << report.chi_square.p_value;
  }
  return out.str();
}

}  // namespace

DirectionBins::DirectionBins(int rows, int columns, RowSpacing spacing) {
  assert(rows >= 2 && rows % 2 == 0 && columns >= 1);
  for (int i = 0; i <= rows; ++i) {
    const double part = static_cast<double>(i) / rows;
    z_.push_back(spacing == RowSpacing::equal_z ? 2 * part - 1 : -std::cos(exact_pi * part));
  }
  z_[static_cast<std::size_t>(rows / 2)] = 0;
  for (int i = 0; i <= columns; ++i)
    phi_.push_back(2 * exact_pi * i / columns);
}

std::size_t DirectionBins::index_of(vec3 direction) const {
  const auto part_of = [](const std::vector<double>& edges, double value) {
    const auto inner = edges.begin() + 1;  // an edge belongs to the bin above it
    return static_cast<std::size_t>(std::upper_bound(inner, edges.end() - 1, value) - inner);
  };
  double phi = std::atan2(double{direction.y}, double{direction.x});
  if (phi < 0) phi += 2 * exact_pi;
  return part_of(z_, direction.z) * static_cast<std::size_t>(columns()) + part_of(phi_, phi);
}

std::vector<double> integrate_bins(const DirectionBins& bins, const DirectionFunction& f,
                                   double tolerance) {
  std::vector<double> integrals;
  for (int row = 0; row < bins.rows(); ++row)
    for (int column = 0; column < bins.columns(); ++column) {
      const Cell cell{bins.z_edge(row), bins.z_edge(row + 1), bins.phi_edge(column),
                      bins.phi_edge(column + 1)};
      integrals.push_back(integrate_cell(f, cell, gauss(f, cell), tolerance));
    }
  return integrals;
}

double integrate_directions(const DirectionFunction& f, double tolerance) {
  const DirectionBins bins(16, 16, RowSpacing::equal_angle);
  double sum = 0;
  for (const double part : integrate_bins(bins, f, tolerance / static_cast<double>(bins.size())))
    sum += part;
  return sum;
}

// [test-sampler]
SamplerReport test_sampler(const DrawDirection& draw, const DirectionFunction& pdf,
                           const SamplerOptions& options) {
  const DirectionBins& bins = options.bins;
  SamplerReport report{};
  report.observed.resize(bins.size() + 1);
  for (int i = 0; i < options.samples; ++i) {
    const auto direction = draw();
    if (direction && !is_unit(*direction)) report.complaint = text(*direction) + " is not unit";
    ++report.observed[direction ? bins.index_of(*direction) : bins.size()];
  }
  report.expected = integrate_bins(bins, pdf);
  for (const double share : report.expected)
    report.integral += share;
  report.expected.push_back(std::max(0.0, 1 - report.integral));
  for (double& share : report.expected)
    share *= options.samples;
  report.chi_square = chi_square(report.observed, report.expected);
  if (report.complaint.empty()) report.complaint = complaint_about(report);
  return report;
}
// [test-sampler]

std::string complaint_about(const Triple& sample, double tolerance) {
  std::ostringstream out;
  out << "wi = " << text(sample.wi) << ": ";
  if (!is_unit(sample.wi)) {
    out << "not unit";
  } else if (!(sample.pdf > 0 && std::isfinite(sample.pdf))) {
    out << "sampled, but its density is " << sample.pdf;
  } else if (!is_near(sample.pdf, sample.sample_pdf, tolerance)) {
    out << "sample() says its density is " << sample.sample_pdf << ", pdf() says " << sample.pdf;
  } else if (!is_finite_and_not_negative(sample.weight)) {
    out << "its weight is " << text(sample.weight);
  } else {
    for (glm::length_t c = 0; c < 3; ++c) {
      if (is_near(sample.weight[c], sample.eval_cosine[c] / sample.pdf, tolerance)) continue;
      out << "its weight is " << text(sample.weight) << ", but eval |cos| / pdf is "
          << text(sample.eval_cosine / sample.pdf);
      return out.str();
    }
    return "";
  }
  return out.str();
}

std::string complaint_about_unsampled(vec3 wi, vec3 eval_cosine, float pdf) {
  std::ostringstream out;
  out << "wi = " << text(wi) << ": ";
  if (!is_finite_and_not_negative(eval_cosine)) {
    out << "eval |cos| is " << text(eval_cosine);
  } else if (!(pdf >= 0 && std::isfinite(pdf))) {
    out << "its density is " << pdf;
  } else if (pdf == 0 && std::max({eval_cosine.x, eval_cosine.y, eval_cosine.z}) > 0) {
    out << "light from there would be scattered, but no sample goes there";
  } else {
    return "";
  }
  return out.str();
}

}  // namespace lt
