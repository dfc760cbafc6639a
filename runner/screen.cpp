#include "runner/screen.hpp"

#include <algorithm>

#include "common/files.hpp"
#include "runner/terminal.hpp"
#include "runner/text.hpp"

namespace lt {

namespace {

// "chapter 2, about 20 min"
std::string where_and_how_long(const Exercise& exercise) {
  return "chapter " + std::to_string(std::stoi(exercise.id)) + ", about " +
         std::to_string(exercise.minutes) + " min";
}

std::string indented(const std::vector<std::string>& lines, std::size_t at_most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(lines.size(), at_most); ++i) {
    std::string line = printable(lines[i]);
    if (line.size() > 200) line = line.substr(0, 200) + "...";
    text += "    " + line + "\n";
  }
  if (lines.size() > at_most) {
    text += "    ... and " + std::to_string(lines.size() - at_most) + " lines more\n";
  }
  return text;
}

std::string coloured(VerdictKind kind) {
  if (kind == VerdictKind::done) return ink::green("done");
  return kind == VerdictKind::not_yet ? ink::red("not yet") : ink::yellow("not started");
}

std::string how_to_go_on(const Exercise& exercise, Mode mode) {
  if (mode == Mode::keys) return "s shows the solution, n opens the next exercise.";
  return "The solution can be shown now: ./learn solution " + exercise.id +
         ". The next exercise: ./learn next.";
}

}  // namespace

std::string card(const Lesson& lesson, const Exercise& exercise) {
  const int width = terminal_columns();
  const std::string right = where_and_how_long(exercise);
  const std::string left = exercise.id + "  " + exercise.title;
  const int gap = width - static_cast<int>(left.size() + right.size());
  std::string text = ink::bold(left);
  if (gap >= 2) text += std::string(static_cast<std::size_t>(gap), ' ') + ink::dim(right);
  text += "\n\n";
  text += "  write in   " + ink::cyan(shown_path(lesson.workspace().answer(exercise))) + "\n";
  text += "  the task   " + ink::cyan(shown_path(exercise.folder / "README.md")) + "\n";
  return text;
}

std::string verdict_text(const Lesson& lesson, const Exercise& exercise, const Verdict& verdict,
                         Mode mode) {
  const int width = terminal_columns();
  std::string place = shown_path(lesson.workspace().answer(exercise));
  if (verdict.line > 0) place += ":" + std::to_string(verdict.line);
  std::string text = coloured(verdict.kind) + "   " + place + "\n\n";

  switch (verdict.kind) {
    case VerdictKind::not_started:
      text += wrapped("TODO: " + verdict.says, width, 2);
      text += wrapped("This is expected: replace the TODO by your code and save.", width, 2);
      break;
    case VerdictKind::not_yet:
      text += wrapped(verdict.says, width, 2);
      if (!verdict.details.empty()) text += "\n" + indented(verdict.details, 8);
      break;
    case VerdictKind::done:
      text += "  Every check holds.\n";
      if (!verdict.measured.empty()) text += "\n" + indented(verdict.measured, 12);
      text += "\n" + wrapped(how_to_go_on(exercise, mode), width, 2);
      break;
  }
  if (!verdict.printed.empty()) {
    text += "\n  " + ink::dim("Your program printed:") + "\n" + indented(verdict.printed, 12);
  }
  return text;
}

std::string hints_text(const Exercise& exercise, int count, Mode mode) {
  const int width = terminal_columns();
  const int all = static_cast<int>(exercise.hints.size());
  std::string text;
  for (int i = 0; i < std::min(count, all); ++i) {
    text += ink::yellow("hint " + std::to_string(i + 1) + " of " + std::to_string(all)) + "\n" +
            wrapped(exercise.hints[static_cast<std::size_t>(i)], width, 2);
  }
  if (count >= all) {
    text += ink::dim("These were all hints.");
    if (mode == Mode::commands) {
      text += ink::dim(" The solution: ./learn solution " + exercise.id + " --anyway");
    }
    text += "\n";
  }
  return text;
}

std::string progress_bar(int done, int all) {
  const std::string count = std::to_string(done) + " of " + std::to_string(all) + " done";
  const int length = std::min(60, terminal_columns() - static_cast<int>(count.size()) - 3);
  const int full = all > 0 ? length * done / all : 0;
  return "[" + ink::green(std::string(static_cast<std::size_t>(full), '#')) +
         ink::dim(std::string(static_cast<std::size_t>(length - full), '.')) + "] " + count;
}

std::string list_text(const Lesson& lesson) {
  const Exercise& current = lesson.current();
  std::string text;
  std::string chapter;
  for (const Exercise& exercise : lesson.exercises()) {
    if (exercise.chapter != chapter) {
      chapter = exercise.chapter;
      text += (text.empty() ? "" : "\n") + ink::dim(chapter) + "\n";
    }
    const State state = lesson.state(exercise);
    const std::string word = padded(in_words(state), 13);
    const bool is_current = exercise.id == current.id;
    text += is_current ? ink::cyan("> ") : "  ";
    text += exercise.id + "  ";
    text += state == State::done                                   ? ink::green(word)
            : state == State::not_yet || state == State::unchecked ? ink::red(word)
            : state == State::check_again                          ? ink::yellow(word)
                                                                   : ink::dim(word);
    text += padded(exercise.title, 34) + "  " +
            ink::dim(std::to_string(exercise.minutes) + " min  " + exercise.name) + "\n";
  }
  const int all = static_cast<int>(lesson.exercises().size());
  return text + "\n" + progress_bar(lesson.done_count(), all) + "\n";
}

std::string keys_line() {
  std::string text;
  for (const char* key : {"n next", "h hint", "s solution", "l list", "r reset", "q quit"}) {
    text += ink::bold(std::string_view(key).substr(0, 1)) +
            ink::dim(std::string_view(key).substr(1)) + "   ";
  }
  return text;
}

}  // namespace lt
