/// @file
/// What was measured, as a table for people.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/benchmarks/machine.hpp"

namespace lt::bench {

/// "12.6 million", "840 thousand", "95".
[[nodiscard]] inline std::string in_words(double number) {
  char text[40];
  if (number >= 1e6) {
    std::snprintf(text, sizeof text, "%.1f million", number * 1e-6);
  } else if (number >= 1e3) {
    std::snprintf(text, sizeof text, "%.0f thousand", number * 1e-3);
  } else {
    std::snprintf(text, sizeof text, "%.0f", number);
  }
  return text;
}

/// Prints a line for each benchmark: the best of its repetitions, since whatever else the machine
/// does can only add.
class Table : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override {
    const std::vector<double>& load = context.cpu_info.load_avg;
    std::printf("%s, %d processors\n%s, %s\n", processor_name().c_str(), context.cpu_info.num_cpus,
                compiler_name().c_str(), LT_BENCHMARK_FLAGS);
    if (!load.empty() && load[0] > 0.5)
      std::printf("Other programs are running (load %.1f): alone it would be faster.\n", load[0]);
    return true;
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    const Run* best = nullptr;
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration && (!best || per_second(run) > per_second(*best)))
        best = &run;
    if (best) print(*best);
  }

 private:
  static double per_second(const Run& run) { return run.counters.at("items_per_second"); }

  void print(const Run& run) {
    const std::string name = run.run_name.function_name;
    const std::size_t slash = name.find('/');
    const std::string group = name.substr(0, slash);
    if (group != group_) std::printf("\n%s\n", group.c_str());
    group_ = group;
    const double rate = per_second(run);
    const std::string done = in_words(rate) + " " + run.report_label;
    std::printf("  %-32s%-26s%8.1f ns", name.substr(slash + 1).c_str(), done.c_str(), 1e9 / rate);
    const auto queries = run.counters.find("queries");
    if (queries != run.counters.end())
      std::printf("   %s queries", in_words(queries->second).c_str());
    std::printf("\n");
    std::fflush(stdout);
  }

  std::string group_;
};

}  // namespace lt::bench
