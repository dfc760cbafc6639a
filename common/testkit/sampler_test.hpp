/// @file
/// Does a sampler of directions do what its density says? Asked of every sampler of the course.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/math.hpp"
#include "common/testkit/statistics.hpp"

namespace lt {

/// One direction (unit), or nothing where the sampler's numbers lead nowhere.
using DrawDirection = std::function<std::optional<vec3>()>;

/// A function of directions (unit), for example a density, 1/sr.
using DirectionFunction = std::function<double(vec3)>;

// [direction-bins]
/// Where the edges between rows of bins lie.
enum class RowSpacing {
  equal_z,     ///< all bins have the same solid angle (Archimedes)
  equal_angle  ///< rows of equal polar angle: finer around the poles, for narrow lobes
};

/// Bins over all directions: rows between planes z = constant, columns between azimuths phi.
class DirectionBins {
 public:
  /// @param rows     even, so that the horizon z = 0 is an edge; >= 2
  /// @param columns  >= 1
  explicit DirectionBins(int rows = 24, int columns = 32, RowSpacing spacing = RowSpacing::equal_z);

  [[nodiscard]] int rows() const { return static_cast<int>(z_.size()) - 1; }
  [[nodiscard]] int columns() const { return static_cast<int>(phi_.size()) - 1; }
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(rows()) * static_cast<std::size_t>(columns());
  }
  /// Edge `i` of the rows, from z = -1 (0) to z = 1 (rows()).
  [[nodiscard]] double z_edge(int i) const { return z_[static_cast<std::size_t>(i)]; }
  /// Edge `i` of the columns, radians, from 0 (0) to 2 pi (columns()).
  [[nodiscard]] double phi_edge(int i) const { return phi_[static_cast<std::size_t>(i)]; }

  /// Number of the bin in which a direction lies: row * columns() + column.
  [[nodiscard]] std::size_t index_of(vec3 direction) const;

 private:
  std::vector<double> z_;
  std::vector<double> phi_;
};
// [direction-bins]

/// The integral of `f` over the solid angle of each bin, by adaptive quadrature.
/// @param tolerance  absolute error aimed at in each part of a bin. A peak that is so narrow that
///                   no point of a first coarse grid sees it is missed; a jump costs accuracy.
[[nodiscard]] std::vector<double> integrate_bins(const DirectionBins& bins,
                                                 const DirectionFunction& f,
                                                 double tolerance = 1e-7);

/// The integral of `f` over all directions.
[[nodiscard]] double integrate_directions(const DirectionFunction& f, double tolerance = 1e-6);

// [sampler-report]
struct SamplerOptions {
  int samples = 1'000'000;
  DirectionBins bins{};
};

/// What came of testing a sampler.
struct SamplerReport {
  std::vector<double> observed;  ///< samples in each bin, then those that led nowhere
  std::vector<double> expected;  ///< the same by the density
  double integral;               ///< of the density over all directions; the rest leads nowhere
  ChiSquare chi_square;
  std::string complaint;  ///< what is wrong, in words; empty if nothing is
};
// [sampler-report]

/// Pearson's chi-square of `draw` against `pdf`. Draws that lead nowhere are a bin of their own,
/// which expects what the density leaves of 1. Complains if p < 1e-6, if the density is negative,
/// NaN or more than 1 in all, and if a direction is not unit.
/// @param pdf  the density with which `draw` gives a direction, 1/sr, over all directions
[[nodiscard]] SamplerReport test_sampler(const DrawDirection& draw, const DirectionFunction& pdf,
                                         const SamplerOptions& options = {});

/// What the parts of a BSDF say of one pair of directions, to be compared.
struct Triple {
  vec3 wi;
  vec3 eval_cosine;  ///< eval(wo, wi) |cos theta_i|
  float pdf;         ///< pdf(wo, wi)
  vec3 weight;       ///< as sample() gave it, with
  float sample_pdf;  ///< its density
};

/// What is wrong with a sample; "" if nothing is.
/// @param tolerance  relative
[[nodiscard]] std::string complaint_about(const Triple& sample, double tolerance);

/// What is wrong with a direction that nobody sampled; "" if nothing is.
[[nodiscard]] std::string complaint_about_unsampled(vec3 wi, vec3 eval_cosine, float pdf);

// [triple]
/// Do sample, eval and pdf of a BSDF (chapter 5's concept) belong together? No chi-square sees a
/// wrong weight. For `count` samples: weight pdf = eval |cos|, and the density is pdf()'s. For
/// `count` directions of the whole sphere: nothing is negative, infinite or NaN, and where light
/// would be scattered, a sample may go.
/// @param random     has next_vec3(): three numbers in [0, 1)
/// @param tolerance  relative
/// @return the first complaint, or ""
template <class AnyBsdf, class Random>
[[nodiscard]] std::string triple_complaint(const AnyBsdf& bsdf, vec3 wo, int count, Random& random,
                                           double tolerance = 1e-4) {
  for (int i = 0; i < count; ++i) {
    const vec3 u = random.next_vec3();
    if (const auto sample = bsdf.sample(wo, u)) {
      const vec3 wi = sample->wi;
      const Triple triple{wi, bsdf.eval(wo, wi) * std::abs(wi.z), bsdf.pdf(wo, wi), sample->weight,
                          sample->pdf};
      const std::string complaint = complaint_about(triple, tolerance);
      if (!complaint.empty()) return complaint;
    }
    const float z = 1.0f - 2.0f * u.x;
    const float radius = std::sqrt(1.0f - z * z);
    const vec3 wi(radius * std::cos(2.0f * pi * u.y), radius * std::sin(2.0f * pi * u.y), z);
    const std::string complaint =
        complaint_about_unsampled(wi, bsdf.eval(wo, wi) * std::abs(wi.z), bsdf.pdf(wo, wi));
    if (!complaint.empty()) return complaint;
  }
  return "";
}
// [triple]

}  // namespace lt
