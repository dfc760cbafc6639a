#include "common/timing.hpp"

#include <cmath>
#include <vector>

#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// Some work, in proportion to `steps`.
double work(int steps) {
  volatile double sum = 0;
  for (int i = 0; i < steps; ++i)
    sum = sum + std::sqrt(i);
  return sum;
}

}  // namespace

TEST_CASE("timing: the timer counts work in seconds") {
  const std::clock_t start = std::clock();
  const ProcessorTimer timer;
  while (std::clock() - start < CLOCKS_PER_SEC / 10) {
  }
  CHECK(timer.seconds() > 0.09);  // a tenth of a second has been worked
  const double found = timer.seconds();
  CHECK(found <= static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
}

TEST_CASE("timing: five runs of as many calls as are asked for") {
  std::vector<int> calls(3);
  const double found = best_nanoseconds(3, [&](int i) {
    ++calls[static_cast<std::size_t>(i)];
    return 1.0;
  });
  CHECK(calls == std::vector<int>{5, 5, 5});
  CHECK(found >= 0);
}

TEST_CASE("timing: ten times the work takes longer and is told for one call") {
  const double little = best_nanoseconds(20'000, [](int) { return work(100); });
  const double much = best_nanoseconds(2'000, [](int) { return work(1'000); });
  CHECK(much > 4 * little);
  // A hundred square roots take more than 20 nanoseconds and less than 20,000 on any machine.
  CHECK(little > 20);
  CHECK(little < 20'000);
}

TEST_CASE("timing: a run that something disturbs does not count") {
  int calls = 0;
  const double found = best_nanoseconds(100, [&](int) {
    ++calls;
    return work(calls <= 400 ? 10'000 : 100);  // four slow runs, then a quick one
  });
  const double quick = best_nanoseconds(100, [](int) { return work(100); });
  CHECK(found < 10 * quick + 1000);
}
