// What is measured of the whole course: its tests and its speed.
#include <iostream>

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/parallel.hpp"
#include "runner/build.hpp"
#include "runner/commands.hpp"
#include "runner/process.hpp"
#include "runner/test_report.hpp"

namespace lt {

namespace fs = std::filesystem;

int test_command(const Home& home, Arguments& arguments) {
  const std::string preset = arguments.flag("--sanitize") ? "asan" : "release";
  const std::vector<std::string> for_ctest = arguments.after_dashes();
  const std::string word = arguments.word_or_nothing();
  const std::string chapter = word.empty() ? "" : find_chapter(home, word);
  configure(home, preset);
  if (chapter.empty())
    build(home.build(preset), {}, "building everything");
  else
    build(home.build(preset), {chapter + "_tests"}, "building the tests of " + chapter);

  const fs::path junit = home.build(preset) / "tests.xml";
  fs::remove(junit);
  std::vector<std::string> command{"ctest",
                                   "--test-dir",
                                   home.build(preset).string(),
                                   "--build-config",
                                   "Release",
                                   "--output-on-failure",
                                   "--no-tests=error",
                                   "--output-junit",
                                   junit.string(),
                                   "-j",
                                   std::to_string(thread_count(0))};
  if (!chapter.empty()) command.insert(command.end(), {"-L", chapter});
  command.insert(command.end(), for_ctest.begin(), for_ctest.end());
  const ProcessResult result = run_visibly(command);
  if (!fs::exists(junit)) throw OutputError("ctest did not run: see above");

  const TestReport report = read_test_report(read_file(junit));
  for (const std::string& name : report.not_run)
    std::cout << "not run: " << name << '\n';
  for (const std::string& name : report.failed)
    std::cout << "failed: " << name << '\n';
  const bool is_unexplained = report.failures() == 0 && !result.succeeded();
  std::cout << report.passed << " passed, " << report.failures() + (is_unexplained ? 1 : 0)
            << " failed" << std::endl;
  return result.succeeded() && report.failures() == 0 ? 0 : 1;
}

int bench_command(const Home& home, Arguments& arguments) {
  const std::string seconds = arguments.flag("--quick") ? "0.02" : "0.3";
  arguments.nothing_more();
  // A folder of its own: what is built for this machine alone must not end up in a release.
  const fs::path folder = home.build("bench");
  configure_folder(
      home.root, folder,
      {"-DCMAKE_BUILD_TYPE=Release", "-DLT_BENCHMARKS=ON", "-DLT_NATIVE=ON", "-DLT_TESTS=OFF"});
  build(folder, {"course_benchmarks"}, "building the benchmarks");
  const fs::path program = built_program(folder / "tests" / "benchmarks", "course_benchmarks");
  const ProcessResult result = run_visibly({program.string(), "--benchmark_min_time=" + seconds});
  if (!result.succeeded()) throw OutputError("the benchmarks did not run: see above");
  return 0;
}

}  // namespace lt
