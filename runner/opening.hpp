/// @file
/// Opening, merging and resetting an exercise, with the sentence that tells the learner of it.
#pragma once

#include <filesystem>
#include <string>

#include "runner/lesson.hpp"

namespace lt {

/// What to say when an exercise has been opened.
struct Opening {
  std::string note;        ///< one sentence, or empty
  bool can_merge = false;  ///< its starter has changed, and so has the learner's file
};

/// Makes sure that the learner's file is there.
Opening open_exercise(const Lesson& lesson, const Exercise& exercise);

/// Merges the changed starter into the learner's file.
/// @return what became of it, in a sentence
std::string merge_exercise(const Lesson& lesson, const Exercise& exercise);

/// Remembers that the learner does not want this version of the starter.
/// @return a sentence
std::string decline_merge(const Lesson& lesson, const Exercise& exercise);

/// Puts the starter back and forgets hints and verdict.
/// @return where the old file is
std::filesystem::path reset_exercise(const Lesson& lesson, const Exercise& exercise);

}  // namespace lt
