/// @file
/// What CTest found, counted our way: a test that did not run is a failure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lt {

struct TestReport {
  int passed = 0;
  std::vector<std::string> failed;   ///< names
  std::vector<std::string> not_run;  ///< names: skipped, disabled, not built

  [[nodiscard]] int failures() const { return static_cast<int>(failed.size() + not_run.size()); }
};

/// @param junit  the file that `ctest --output-junit` wrote
[[nodiscard]] TestReport read_test_report(std::string_view junit);

}  // namespace lt
