/// @file
/// From what a compiler or a test program printed to the one sentence that a learner reads.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "runner/exercise.hpp"
#include "runner/process.hpp"

namespace lt {

/// A line that the test program printed for us, see common/testkit/exercise.hpp.
struct Finding {
  std::string tag;   ///< "near-root-only"
  std::string seen;  ///< what the learner's code gave
};

/// A body that still says TODO.
struct NotWrittenYet {
  std::string file;
  int line = 0;
  std::string what_to_do;
};

/// A check of test.cpp that did not hold.
struct FailedCheck {
  std::string sentence;    ///< the test case's name: what ought to hold
  std::string expression;  ///< as written in test.cpp
  std::string values;      ///< the same with the values that were there; may be empty
  std::string message;     ///< more words about it; may be empty
  int line = 0;            ///< in test.cpp
};

/// What a test program printed, taken apart.
struct TestOutput {
  std::optional<NotWrittenYet> not_written;  ///< the first
  std::vector<Finding> findings;             ///< in the order printed
  bool is_todo_first = false;                ///< the TODO came before the first finding
  std::vector<std::string> measured;
  std::vector<std::string> printed;  ///< everything else: the learner's own output
  std::optional<FailedCheck> failed_check;

  [[nodiscard]] std::set<std::string> tags() const;
};

/// @param output    the program's stdout and stderr
/// @param report    Catch2's compact report, which goes to a file of its own
/// @param test_cpp  the text of test.cpp, where the failing test case's name is looked up
[[nodiscard]] TestOutput read_test_output(std::string_view output, std::string_view report,
                                          std::string_view test_cpp);

/// The first error that a compiler or linker reported about the learner's file.
struct BuildError {
  int line = 0;          ///< in the learner's file; 0 if unknown
  int column = 0;        ///< 0 if unknown
  std::string message;   ///< one or two sentences
  std::string location;  ///< the line of code itself; may be empty
};

/// @param output  what the build printed
/// @param answer  the learner's file
/// @return nothing if no error in it concerns that file
[[nodiscard]] std::optional<BuildError> first_build_error(std::string_view output,
                                                          const std::filesystem::path& answer);

/// "It read or wrote memory that is not its own (SIGSEGV)": what a signal means.
[[nodiscard]] std::string signal_in_words(int signal);

/// True if a sanitizer stopped the program.
[[nodiscard]] bool is_sanitizer_report(std::string_view output);

enum class VerdictKind { not_started, not_yet, done };

/// What the learner is told.
struct Verdict {
  VerdictKind kind = VerdictKind::not_yet;
  int line = 0;                       ///< in the learner's file; 0 if none
  std::string says;                   ///< the diagnosis, one sentence or two
  std::vector<std::string> details;   ///< lines below it: code, values
  std::vector<std::string> measured;  ///< only when done
  std::vector<std::string> printed;   ///< the learner's own output
};

/// The verdict on an answer that does not compile.
[[nodiscard]] Verdict verdict_on_build(const BuildError& error);

/// The verdict on an answer whose test has run.
/// @param seconds_allowed  named where the time was over
[[nodiscard]] Verdict verdict_on_run(const Exercise& exercise, const ProcessResult& result,
                                     const TestOutput& output, double seconds_allowed);

}  // namespace lt
