/// @file
/// What random numbers cost, measured.
#pragma once

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>
#include <random>
#include <string>

#include "ch04_monte_carlo/streams.hpp"
#include "common/testkit/statistics.hpp"

namespace lt {

// [nanoseconds]
/// Processor time of one `draw(i)`, nanoseconds: the best of five runs, since whatever else the
/// machine does can only add.
/// @param draw  called with 0, 1, 2, ... count - 1, returns a number
template <class Draw>
[[nodiscard]] double nanoseconds(int count, const Draw& draw) {
  double best = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 5; ++run) {
    double sum = 0;  // asked for below, so that no compiler leaves the work out
    const std::clock_t start = std::clock();
    for (int i = 0; i < count; ++i)
      sum += draw(i);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (sum >= 0) best = std::min(best, 1e9 * seconds / count);
  }
  return best;
}
// [nanoseconds]

/// Measures on this machine; takes some seconds.
[[nodiscard]] inline std::string cost_table() {
  Pcg32 pcg(1);
  std::mt19937 twister(1);
  RunningMean mean;
  const auto unit = [](std::uint32_t bits) { return static_cast<double>(unit_float(bits)); };
  const auto next = [&](int) { return unit(pcg.next_bits()); };
  const auto next_of_twister = [&](int) { return unit(static_cast<std::uint32_t>(twister())); };
  const auto first = [&](int i) { return unit(stream_for(1, i, 0, 0).next_bits()); };
  const auto first_of_twister = [&](int i) {
    std::mt19937 fresh(static_cast<std::uint32_t>(i));
    return unit(static_cast<std::uint32_t>(fresh()));
  };
  const auto add = [&](int i) {
    mean.add(i);
    return 1.0;
  };
  constexpr int many = 20'000'000;
  std::string table = "nanoseconds each, best of five runs\n";
  const auto say = [&](const char* name, double found, std::size_t bytes) {
    char text[100];
    std::snprintf(text, sizeof text, "%-34s%8.2f   %4zu bytes\n", name, found, bytes);
    table += text;
  };
  say("Pcg32, a number", nanoseconds(many, next), sizeof pcg);
  say("std::mt19937, a number", nanoseconds(many, next_of_twister), sizeof twister);
  say("stream_for() and its first number", nanoseconds(many, first), sizeof pcg);
  say("std::mt19937 seeded, first number", nanoseconds(100'000, first_of_twister), sizeof twister);
  say("RunningMean::add()", nanoseconds(many, add), sizeof mean);
  return table;
}

}  // namespace lt
