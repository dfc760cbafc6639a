/// @file
/// What random numbers cost, measured.
#pragma once

#include <cstdio>
#include <random>
#include <string>

#include "ch04_monte_carlo/streams.hpp"
#include "common/testkit/statistics.hpp"
#include "common/timing.hpp"

namespace lt {

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
  say("Pcg32, a number", best_nanoseconds(many, next), sizeof pcg);
  say("std::mt19937, a number", best_nanoseconds(many, next_of_twister), sizeof twister);
  say("stream_for() and its first number", best_nanoseconds(many, first), sizeof pcg);
  say("std::mt19937 seeded, first number", best_nanoseconds(100'000, first_of_twister),
      sizeof twister);
  say("RunningMean::add()", best_nanoseconds(many, add), sizeof mean);
  return table;
}

}  // namespace lt
