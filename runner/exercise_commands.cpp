// The learner's commands: learn, next, list, run, hint, solution, reset, verify.
#include <iostream>

#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/commands.hpp"
#include "runner/opening.hpp"
#include "runner/proof.hpp"
#include "runner/screen.hpp"
#include "runner/terminal.hpp"
#include "runner/text.hpp"
#include "runner/watch.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

constexpr int not_done = 1;

std::string one_line(const Lesson& lesson, const Exercise& exercise, const Verdict& verdict) {
  if (verdict.kind == VerdictKind::done) return "";
  std::string text = lesson.workspace().answer(exercise).filename().string();
  if (verdict.line > 0) text += ":" + std::to_string(verdict.line);
  return text + ": " + verdict.says;
}

// Checks every file that the learner has, one line each.
// @return how many of them are not done
int check_all(const Lesson& lesson) {
  int open_count = 0;
  int failed = 0;
  for (const Exercise& exercise : lesson.exercises()) {
    if (!lesson.workspace().has_answer(exercise)) continue;
    ++open_count;
    const Verdict verdict = lesson.check(exercise);
    const std::string word = padded(in_words(lesson.state(exercise)), 13);
    const bool is_done = verdict.kind == VerdictKind::done;
    if (!is_done) ++failed;
    std::cout << exercise.id << "  " << padded(exercise.name, 22)
              << (is_done ? ink::green(word) : ink::red(word))
              << one_line(lesson, exercise, verdict) << std::endl;
  }
  if (open_count == 0) std::cout << "No exercise has been opened yet: ./learn opens the first.\n";
  return failed;
}

// A broken progress.json is said in one line and made anew from the learner's files.
Lesson start_lesson(const Home& home) {
  Lesson lesson(home);
  const fs::path& file = lesson.progress().path();
  if (!lesson.progress().is_broken()) return lesson;
  std::cout << shown_path(file) << " cannot be read; it is made anew from your files." << std::endl;
  fs::remove(file);
  check_all(lesson);
  return lesson;
}

const Exercise& chosen(const Lesson& lesson, const std::string& word) {
  return word.empty() ? lesson.current() : find_exercise(lesson.exercises(), word);
}

void tell(const Opening& opening, const Exercise& exercise) {
  if (opening.note.empty()) return;
  std::cout << '\n' << wrapped(opening.note, terminal_columns(), 2);
  if (opening.can_merge) {
    std::cout << "  ./learn run " << exercise.id << " --merge merges the new starter into it.\n";
  }
}

int check_and_tell(const Lesson& lesson, const Exercise& exercise, bool wants_merge) {
  lesson.set_current(exercise);
  const Opening opening = open_exercise(lesson, exercise);
  std::cout << card(lesson, exercise);
  const bool can_merge =
      wants_merge &&
      lesson.workspace().open(exercise, lesson.home().workspace) == Opened::starter_changed;
  if (can_merge) {
    std::cout << '\n' << wrapped(merge_exercise(lesson, exercise), terminal_columns(), 2);
  } else if (wants_merge) {
    std::cout << "\n  There is nothing to merge: your file has today's starter in it.\n";
  } else {
    tell(opening, exercise);
  }
  const Verdict verdict = lesson.check(exercise);
  const int all = static_cast<int>(lesson.exercises().size());
  std::cout << '\n'
            << verdict_text(lesson, exercise, verdict, Mode::commands) << '\n'
            << progress_bar(lesson.done_count(), all) << std::endl;
  return verdict.kind == VerdictKind::done ? 0 : not_done;
}

int learn_command(const Home& home, Arguments& arguments) {
  arguments.nothing_more();
  const Lesson lesson = start_lesson(home);
  if (stdin_is_terminal() && stdout_is_terminal()) return watch(lesson);
  return check_and_tell(lesson, lesson.current(), false);
}

int next_command(const Home& home, Arguments& arguments) {
  arguments.nothing_more();
  const Lesson lesson = start_lesson(home);
  const bool has_begun = !lesson.progress().load().current.empty();
  const Exercise* next = has_begun ? lesson.next_after(lesson.current()) : &lesson.current();
  if (next == nullptr) {
    std::cout << (lesson.state(lesson.current()) == State::done
                      ? "Every exercise is done.\n"
                      : "Every other exercise is done: this is the last one.\n");
    return 0;
  }
  lesson.set_current(*next);
  const Opening opening = open_exercise(lesson, *next);
  std::cout << card(lesson, *next);
  tell(opening, *next);
  std::cout << "\n  ./learn watches your file, ./learn run checks it once.\n";
  return 0;
}

int list_command(const Home& home, Arguments& arguments) {
  arguments.nothing_more();
  std::cout << list_text(start_lesson(home));
  return 0;
}

int run_command(const Home& home, Arguments& arguments) {
  const bool wants_merge = arguments.flag("--merge");
  const std::string word = arguments.word_or_nothing();
  const Lesson lesson = start_lesson(home);
  return check_and_tell(lesson, chosen(lesson, word), wants_merge);
}

int hint_command(const Home& home, Arguments& arguments) {
  const std::string word = arguments.word_or_nothing();
  const Lesson lesson = start_lesson(home);
  const Exercise& exercise = chosen(lesson, word);
  int count = 0;
  lesson.change_record(exercise, [&](Record& record) {
    record.hints = std::min(record.hints + 1, 3);
    count = record.hints;
  });
  std::cout << ink::bold(exercise.id + "  " + exercise.title) << "\n\n"
            << hints_text(exercise, count, Mode::commands);
  return 0;
}

int solution_command(const Home& home, Arguments& arguments) {
  const bool anyway = arguments.flag("--anyway");
  const std::string word = arguments.word_or_nothing();
  const Lesson lesson = start_lesson(home);
  const Exercise& exercise = chosen(lesson, word);
  if (!anyway && !lesson.record(exercise).is_done) {
    std::cout << exercise.id << " is not done yet. ./learn hint " << exercise.id
              << " helps on; --anyway shows the solution all the same.\n";
    return not_done;
  }
  const fs::path file = exercise.folder / "solution.cpp";
  std::cout << ink::dim(shown_path(file)) << "\n\n" << read_file(file);
  return 0;
}

int reset_command(const Home& home, Arguments& arguments) {
  const std::string word = arguments.word_or_nothing();
  const Lesson lesson = start_lesson(home);
  const Exercise& exercise = chosen(lesson, word);
  const fs::path saved = reset_exercise(lesson, exercise);
  std::cout << "The starter is back in " << shown_path(lesson.workspace().answer(exercise))
            << ". Your old file is " << shown_path(saved) << ".\n";
  return 0;
}

}  // namespace

int verify_command(const Home& home, Arguments& arguments) {
  ProofChoice choice;
  const bool all = arguments.flag("--all");
  choice.solutions = arguments.flag("--solutions") || all;
  choice.starters = arguments.flag("--starters") || all;
  choice.mutants = arguments.flag("--mutants") || all;
  choice.fair = arguments.flag("--fair") || all;
  choice.seeds = arguments.number("--seeds", choice.seeds, 1, 10'000'000);
  arguments.nothing_more();
  if (choice.any()) return prove(home, choice);

  const Lesson lesson(home);
  if (lesson.progress().is_broken()) fs::remove(lesson.progress().path());
  const int failed = check_all(lesson);
  const int done = lesson.done_count();
  std::cout << '\n' << progress_bar(done, static_cast<int>(lesson.exercises().size())) << '\n';
  return failed == 0 ? 0 : not_done;
}

std::vector<Command> exercise_commands() {
  const std::string group = "Exercises";
  const std::string id =
      "ID is an exercise's number or name: 02.2 or sphere. Without it: the one "
      "that is open.";
  return {
      {"", group, "", "open the current exercise and watch it",
       "Keys: n next, h hint, s solution, l list, r reset, q quit. Without a terminal the exercise "
       "is checked once.",
       learn_command},
      {"next", group, "", "open the next exercise that is not done", "", next_command},
      {"list", group, "", "show all exercises and how they stand", "", list_command},
      {"run", group, "[ID] [--merge]", "check one exercise once",
       id + " --merge merges a starter that has changed since into your file. Exit code 0 if it is "
            "done, else 1.",
       run_command},
      {"hint", group, "[ID]", "show one hint more", id, hint_command},
      {"solution", group, "[ID] [--anyway]", "show the solution of a finished exercise",
       id + " --anyway shows it unfinished.", solution_command},
      {"reset", group, "[ID]", "put the starter back; your file is saved", id, reset_command},
      {"verify", group, "[--all] [--seeds N]", "check all your files anew",
       "With --solutions, --starters, --mutants, --fair or --all: judge the exercises themselves "
       "instead, the right answers with N seeds (200).",
       verify_command},
      {"judge", "", "FOLDER ANSWER PROGRAM [--seeds N]", "judge one program of an exercise", "",
       judge_command},
      {"measure-edits", "Upkeep", "[--count N]", "time the way from an edit to its verdict",
       "N scripted edits (20) in a folder of their own. Exit code 1 if 95 % take 2 s or more.",
       measure_edits_command},
  };
}

}  // namespace lt
