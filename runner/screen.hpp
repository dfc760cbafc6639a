/// @file
/// What the learner sees: cards, verdicts, the list. Texts only; who prints them is another matter.
#pragma once

#include <string>

#include "runner/lesson.hpp"

namespace lt {

/// How the person goes on from here: keys in the watch, commands elsewhere.
enum class Mode { keys, commands };

/// Id, title, the learner's file, the page of the task.
[[nodiscard]] std::string card(const Lesson& lesson, const Exercise& exercise);

[[nodiscard]] std::string verdict_text(const Lesson& lesson, const Exercise& exercise,
                                       const Verdict& verdict, Mode mode);

/// The first `count` hints.
[[nodiscard]] std::string hints_text(const Exercise& exercise, int count, Mode mode);

/// "[######..............] 3 of 9 done"
[[nodiscard]] std::string progress_bar(int done, int all);

/// All exercises, one a line, the current one marked.
[[nodiscard]] std::string list_text(const Lesson& lesson);

[[nodiscard]] std::string keys_line();

}  // namespace lt
