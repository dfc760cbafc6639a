#include "runner/verdict.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <csignal>

#include "runner/text.hpp"

namespace lt {

std::string signal_in_words(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "it read or wrote memory that is not its own (SIGSEGV): an index, a pointer or an "
             "iterator is out of range, or a function calls itself without end";
    case SIGABRT:
      return "it gave up on itself (SIGABRT): an assertion failed or an exception met noexcept";
    case SIGFPE:
      return "it divided a whole number by zero (SIGFPE)";
    case SIGILL:
      return "it ran into an instruction that must not be reached (SIGILL)";
#ifndef _WIN32
    case SIGBUS:
      return "it touched memory that is not there (SIGBUS)";
    case SIGTRAP:
      return "it ran into a trap (SIGTRAP)";
    case SIGKILL:
      return "the system stopped it (SIGKILL): did it ask for too much memory?";
#endif
    default:
      return "signal " + std::to_string(signal) + " stopped it";
  }
}

bool is_sanitizer_report(std::string_view output) {
  return output.find("ERROR: AddressSanitizer") != std::string_view::npos ||
         output.find("WARNING: ThreadSanitizer") != std::string_view::npos ||
         output.find(": runtime error: ") != std::string_view::npos;
}

Verdict verdict_on_build(const BuildError& error) {
  Verdict verdict;
  verdict.line = error.line;
  verdict.says = error.message;
  if (!trimmed(error.location).empty()) {
    verdict.details.push_back(error.location);
    if (error.column > 0 && error.column <= static_cast<int>(error.location.size()) + 1) {
      verdict.details.push_back(std::string(static_cast<std::size_t>(error.column) - 1, ' ') + "^");
    }
  }
  return verdict;
}

namespace {

// A line of the C++ library that says which of its assertions failed, in words. It names the whole
// type before it comes to the point: "FILE:LINE: TYPE::operator[](...) [with ...]: Assertion '__n <
// this->size()' failed."
std::string assertion_in_words(const std::string& line) {
  const std::size_t start = std::min(line.find("Assertion "), line.find("assertion "));
  const std::string assertion = line.substr(start, 200);
  const std::size_t type = line.find("std::");
  if (type > start) return assertion;
  const std::string name = line.substr(type, line.find_first_of("<: ", type + 5) - type);
  return assertion.find("__n < this->size()") != std::string::npos
             ? "an index into a " + name + " is not less than its size"
             : name + ": " + assertion;
}

// Moves that line, if there is one, from what was printed to the verdict's details.
void add_assertion(Verdict& verdict) {
  const auto found = std::find_if(verdict.printed.begin(), verdict.printed.end(), [](auto& line) {
    return line.find("Assertion ") != std::string::npos ||
           line.find("assertion ") != std::string::npos;
  });
  if (found == verdict.printed.end()) return;
  verdict.details.push_back(assertion_in_words(*found));
  verdict.printed.erase(found);
}

std::string sentence(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

std::string in_check(const TestOutput& output) {
  if (!output.failed_check || output.failed_check->sentence.empty()) return "";
  return " while this was checked: \"" + output.failed_check->sentence + "\"";
}

void describe(const FailedCheck& check, Verdict& verdict) {
  verdict.says = check.sentence.empty() ? "A check does not hold."
                                        : "This does not hold yet: \"" + check.sentence + "\"";
  if (!check.expression.empty()) verdict.details.push_back("checked:  " + check.expression);
  if (!check.values.empty()) verdict.details.push_back("there:    " + check.values);
  if (!check.message.empty()) verdict.details.push_back("about it: " + check.message);
  verdict.details.push_back("(test.cpp, line " + std::to_string(check.line) + ")");
}

void describe(const Exercise& exercise, const Finding& finding, Verdict& verdict) {
  const Mutant* mutant = exercise.mutant(finding.tag);
  verdict.says = mutant != nullptr ? mutant->says : finding.seen;
  if (mutant != nullptr && !finding.seen.empty())
    verdict.details.push_back("seen: " + finding.seen);
}

}  // namespace

Verdict verdict_on_run(const Exercise& exercise, const ProcessResult& result,
                       const TestOutput& output, double seconds_allowed) {
  Verdict verdict;
  verdict.printed = output.printed;
  if (output.not_written && output.is_todo_first) {
    verdict.kind = VerdictKind::not_started;
    verdict.line = output.not_written->line;
    verdict.says = output.not_written->what_to_do;
  } else if (!output.findings.empty()) {
    describe(exercise, output.findings.front(), verdict);
  } else if (result.timed_out) {
    const int seconds = static_cast<int>(std::lround(seconds_allowed));
    verdict.says = "It was still running after " + std::to_string(seconds) + " s" +
                   in_check(output) + ". Is there a loop that never ends?";
  } else if (result.signal != 0) {
    verdict.says =
        "The program crashed" + in_check(output) + ". " + sentence(signal_in_words(result.signal));
    add_assertion(verdict);
  } else if (output.failed_check) {
    describe(*output.failed_check, verdict);
  } else if (result.succeeded()) {
    verdict.kind = VerdictKind::done;
    verdict.measured = output.measured;
  } else {
    verdict.says = "The program ended early with exit code " + std::to_string(result.exit_code) +
                   ", before the checks were over.";
  }
  return verdict;
}

}  // namespace lt
