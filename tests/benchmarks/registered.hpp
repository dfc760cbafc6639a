/// @file
/// The parts of the benchmark program. Each adds its benchmarks; their names are "group/what".
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

namespace lt::bench {

void add_numbers();  ///< random numbers and samplers
void add_bsdfs();    ///< Fresnel, and what each kind of surface does
void add_rays();     ///< closest hits
void add_paths();    ///< camera paths, and pictures by one and two threads

/// Adds one benchmark, which is to be run three times.
template <class Measure>
benchmark::internal::Benchmark* add_benchmark(const std::string& name, const Measure& measure) {
  return benchmark::RegisterBenchmark(name.c_str(), measure)->Repetitions(3);
}

/// Says how much was done, for "per second".
inline void report(benchmark::State& state, double items_per_turn, const char* unit) {
  state.SetItemsProcessed(
      static_cast<std::int64_t>(items_per_turn * static_cast<double>(state.iterations())));
  state.SetLabel(unit);
}

}  // namespace lt::bench
