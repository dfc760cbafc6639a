/// @file
/// Are the exercises themselves sound? What CI proves of each of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runner/exercise.hpp"
#include "runner/verdict.hpp"

namespace lt {

/// A test program that has run.
struct AnswerRun {
  ProcessResult result;
  TestOutput output;
};

/// How far a test program may go.
struct RunLimits {
  int seeds = 1;                   ///< the checks with random input go through as many
  double seconds = 10;             ///< time allowed
  bool is_memory_limited = false;  ///< not for programs with a sanitizer, which map terabytes
};

/// Runs the test program of an exercise.
/// @param program  test and answer, linked
[[nodiscard]] AnswerRun run_answer(const Exercise& exercise, const std::filesystem::path& program,
                                   const RunLimits& limits);

/// One of the programs that the root build makes of an exercise.
struct Answer {
  std::string kind;  ///< "solution", "other", "starter" or "mutant_TAG"
  int seeds = 1;
};

/// What must be proved of one exercise: both right answers pass, the starter is not written, every
/// mutant is named.
[[nodiscard]] std::vector<Answer> answers_to_judge(const Exercise& exercise);

/// @return what is wrong with the way in which this answer's program ended; empty if nothing
[[nodiscard]] std::string complaint(const std::string& kind, const AnswerRun& run);

/// "02.2 sphere: the mutant near-root-only is named"
[[nodiscard]] std::string sentence_of(const Exercise& exercise, const Answer& answer);

}  // namespace lt
