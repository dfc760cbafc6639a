// The course's speed, as a table. `./learn bench` builds and runs it.
#include "tests/benchmarks/registered.hpp"
#include "tests/benchmarks/table.hpp"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  lt::bench::add_numbers();
  lt::bench::add_bsdfs();
  lt::bench::add_rays();
  lt::bench::add_paths();
  lt::bench::Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  benchmark::Shutdown();
}
