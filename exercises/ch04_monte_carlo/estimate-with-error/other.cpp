// spread_ holds the variance itself, which changes a little with each number. The points are drawn
// from b towards a, all of them before the first value of f is asked for.
#include "api.hpp"

#include <cmath>
#include <vector>

namespace exercise {

void RunningMean::add(double value) {
  const double n = static_cast<double>(++count_);
  const double step = (value - mean_) / n;  // of the mean
  mean_ += step;
  if (count_ > 1) spread_ += n * step * step - spread_ / (n - 1.0);
}

double RunningMean::mean() const {
  return mean_;
}

double RunningMean::variance() const {
  return spread_;
}

double RunningMean::standard_error() const {
  return count_ == 0 ? 0.0 : std::sqrt(spread_) / std::sqrt(static_cast<double>(count_));
}

RunningMean estimate_uniform(const std::function<double(double)>& f, double a, double b, int n,
                             const std::function<double()>& random) {
  const double width = b - a;
  std::vector<double> points(static_cast<std::size_t>(n));
  for (double& x : points)
    x = b - width * random();
  RunningMean samples;
  for (const double x : points)
    samples.add(f(x) * width);
  return samples;
}

}  // namespace exercise
