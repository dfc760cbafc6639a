/// @file
/// Processor time, measured.
#pragma once

#include <algorithm>
#include <ctime>
#include <limits>

namespace lt {

/// Runs from where it is made on.
class ProcessorTimer {
 public:
  /// Processor time of the program so far, that of all threads together.
  [[nodiscard]] double seconds() const {
    return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
  }

 private:
  std::clock_t start_ = std::clock();
};

/// Processor time of one `work(i)`, nanoseconds: the best of five runs, since whatever else the
/// machine does can only add.
/// @param count  how many make a run
/// @param work   called with 0, 1, 2, ... count - 1; returns a number, not negative
template <class Work>
[[nodiscard]] double best_nanoseconds(int count, const Work& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 5; ++run) {
    double sum = 0;  // asked for below, so that no compiler leaves the work out
    const ProcessorTimer timer;
    for (int i = 0; i < count; ++i)
      sum += work(i);
    const double seconds = timer.seconds();
    if (sum >= 0) best = std::min(best, 1e9 * seconds / count);
  }
  return best;
}

}  // namespace lt
