#include "api.hpp"

#include <cmath>

namespace exercise {

void RunningMean::add(double value) {
  // spread_ is the sum of the squared distances from the mean (Welford 1962). Only distances are
  // squared, never the numbers themselves: they may be large and near each other.
  ++count_;
  const double from_old_mean = value - mean_;
  mean_ += from_old_mean / static_cast<double>(count_);
  const double from_new_mean = value - mean_;
  spread_ += from_old_mean * from_new_mean;
}

double RunningMean::mean() const {
  return mean_;
}

double RunningMean::variance() const {
  // n numbers have n - 1 distances to tell: the last follows, because all of them sum to 0.
  if (count_ < 2) return 0.0;
  return spread_ / static_cast<double>(count_ - 1);
}

double RunningMean::standard_error() const {
  if (count_ < 2) return 0.0;
  return std::sqrt(variance() / static_cast<double>(count_));
}

RunningMean estimate_uniform(const std::function<double(double)>& f, double a, double b, int n,
                             const std::function<double()>& random) {
  RunningMean samples;
  for (int i = 0; i < n; ++i) {
    const double x = a + (b - a) * random();
    // One sample is a guess of the whole area: as if f were f(x) everywhere.
    samples.add((b - a) * f(x));
  }
  return samples;
}

}  // namespace exercise
