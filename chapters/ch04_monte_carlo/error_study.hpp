/// @file
/// How the error of an estimate falls with the number of samples.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "ch04_monte_carlo/integrals.hpp"
#include "ch04_monte_carlo/slope.hpp"
#include "ch04_monte_carlo/streams.hpp"
#include "common/testkit/statistics.hpp"

namespace lt {

/// What an estimate with n samples gives.
using Estimator = std::function<double(int n, Pcg32& random)>;

/// The error of estimates with n samples each, found by repeating.
struct ErrorAtN {
  int n;
  RunningMean squares;  ///< of the errors, one for each repeat

  /// Root of the mean square of the error.
  [[nodiscard]] double rms() const { return std::sqrt(squares.mean()); }
};

// [measure-error]
/// Repeats the estimate for n = first_n, factor first_n, factor^2 first_n, ... last_n, each time
/// with a new stream: with the same one all errors would rise and fall together.
/// @param exact    what is estimated
/// @param repeats  for each n, >= 2
[[nodiscard]] inline std::vector<ErrorAtN> measure_error(const Estimator& estimate, double exact,
                                                         int first_n, int last_n, int repeats,
                                                         std::uint64_t seed, int factor = 2) {
  std::vector<ErrorAtN> errors;
  for (int n = first_n; n <= last_n; n *= factor) {
    ErrorAtN at_n{n, {}};
    for (int repeat = 0; repeat < repeats; ++repeat) {
      Pcg32 random = stream_for(seed, n, repeat, 0);
      const double error = estimate(n, random) - exact;
      at_n.squares.add(error * error);
    }
    errors.push_back(at_n);
  }
  return errors;
}
// [measure-error]

/// The power law that the errors follow.
[[nodiscard]] inline PowerLaw law_of(const std::vector<ErrorAtN>& errors) {
  std::vector<double> n;
  std::vector<double> rms;
  for (const ErrorAtN& error : errors) {
    n.push_back(error.n);
    rms.push_back(error.rms());
  }
  return fit_power_law(n, rms);
}

}  // namespace lt
