#include "runner/lesson.hpp"

#include <algorithm>
#include <filesystem>

#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/build.hpp"
#include "runner/judge.hpp"
#include "runner/text.hpp"

namespace lt {

namespace fs = std::filesystem;

std::string in_words(State state) {
  switch (state) {
    case State::not_opened:
      return "not opened";
    case State::not_started:
      return "not started";
    case State::unchecked:
      return "unchecked";
    case State::not_yet:
      return "not yet";
    case State::done:
      return "done";
    case State::check_again:
      return "check again";
  }
  return "";
}

Lesson::Lesson(Home home)
    : home_(std::move(home)),
      exercises_(load_exercises(home_)),
      workspace_(home_.my),
      progress_(home_.my / "progress.json") {
  if (exercises_.empty()) throw InputError("there are no exercises in " + home_.exercises.string());
}

const Exercise& Lesson::current() const {
  const std::string id = progress_.load().current;
  for (const Exercise& exercise : exercises_) {
    if (exercise.id == id) return exercise;
  }
  const Exercise* next = next_after(exercises_.back());
  return next != nullptr ? *next : exercises_.front();
}

void Lesson::set_current(const Exercise& exercise) const {
  progress_.change([&](LearnerProgress& progress) { progress.current = exercise.id; });
}

const Exercise* Lesson::next_after(const Exercise& exercise) const {
  const auto here = std::find_if(exercises_.begin(), exercises_.end(),
                                 [&](const Exercise& other) { return other.id == exercise.id; });
  const auto start = static_cast<std::size_t>(here - exercises_.begin());
  for (std::size_t i = 1; i <= exercises_.size(); ++i) {
    const Exercise& candidate = exercises_[(start + i) % exercises_.size()];
    if (candidate.id != exercise.id && state(candidate) != State::done) return &candidate;
  }
  return nullptr;
}

Record Lesson::record(const Exercise& exercise) const {
  const LearnerProgress progress = progress_.load();
  const auto found = progress.records.find(exercise.id);
  return found == progress.records.end() ? Record{} : found->second;
}

void Lesson::change_record(const Exercise& exercise,
                           const std::function<void(Record&)>& edit) const {
  progress_.change([&](LearnerProgress& progress) { edit(progress.records[exercise.id]); });
}

State Lesson::state(const Exercise& exercise) const {
  if (!workspace_.has_answer(exercise)) return State::not_opened;
  const Record record = this->record(exercise);
  const bool is_same = record.answer == answer_fingerprint(exercise);
  if (record.is_done) {
    const bool is_same_test = record.test == test_fingerprint(exercise);
    return is_same && is_same_test ? State::done : State::check_again;
  }
  if (workspace_.is_untouched(exercise)) return State::not_started;
  return is_same ? State::not_yet : State::unchecked;
}

int Lesson::done_count() const {
  return static_cast<int>(
      std::count_if(exercises_.begin(), exercises_.end(),
                    [&](const Exercise& exercise) { return state(exercise) == State::done; }));
}

std::string Lesson::answer_fingerprint(const Exercise& exercise) const {
  // An editor may be renaming its new file into place at this very moment.
  try {
    return fingerprint(read_file(workspace_.answer(exercise)));
  } catch (const InputError&) {
    return "";
  }
}

std::string Lesson::test_fingerprint(const Exercise& exercise) const {
  // An update may be bringing a new one at this very moment.
  try {
    const auto formulas = exercise.folder / "formulas.hpp";  // of a long test
    return fingerprint(read_file(exercise.folder / "test.cpp") +
                       read_file(exercise.folder / "api.hpp") +
                       (std::filesystem::exists(formulas) ? read_file(formulas) : ""));
  } catch (const InputError&) {
    return "";
  }
}

Verdict Lesson::check(const Exercise& exercise) const {
  const std::string answer = answer_fingerprint(exercise);
  Verdict verdict = build_and_run(exercise, answer);
  if (verdict.kind == VerdictKind::not_started && !workspace_.is_untouched(exercise)) {
    verdict.kind = VerdictKind::not_yet;
    verdict.says = "This body still says TODO: " + verdict.says;
  }
  change_record(exercise, [&](Record& record) {
    record.is_done = verdict.kind == VerdictKind::done;
    record.answer = answer;
    record.test = test_fingerprint(exercise);
  });
  return verdict;
}

namespace {

// A sanitizer maps more memory than we allow otherwise.
bool has_sanitizer(const fs::path& build_folder) {
  const std::vector<std::string> cache = split_lines(read_file(build_folder / "CMakeCache.txt"));
  return std::find(cache.begin(), cache.end(), "LT_SANITIZE:STRING=") == cache.end();
}

// Build tools go by time. A file that was moved here may be older than the program that was built
// from another one: then only its content tells that it is new.
void make_newer_if_changed(const fs::path& answer, const std::string& fingerprint,
                           const fs::path& mark) {
  std::error_code ignored;
  const bool is_known = fs::exists(mark, ignored) && read_file(mark) == fingerprint;
  if (is_known) return;
  if (fs::exists(mark, ignored) && fs::last_write_time(answer) <= fs::last_write_time(mark)) {
    fs::last_write_time(answer, fs::file_time_type::clock::now(), ignored);
  }
}

}  // namespace

Verdict Lesson::build_and_run(const Exercise& exercise, const std::string& answer) const {
  const FileLock lock(home_.workspace.parent_path() /
                      (home_.workspace.filename().string() + ".lock"));
  configure_folder(home_.root / "exercises", home_.workspace,
                   {"-DLT_MY=" + home_.my.generic_string(),
                    "-DLT_EXERCISES=" + home_.exercises.generic_string()});
  const std::string target = "ex_" + exercise.id;
  const fs::path mark = home_.workspace / (target + ".answer");
  make_newer_if_changed(workspace_.answer(exercise), answer, mark);
  const ProcessResult built = try_build(home_.workspace, target, "building");
  write_file_whole(mark, answer);
  if (!built.succeeded()) {
    const auto error = first_build_error(built.output, workspace_.answer(exercise));
    if (!error) throw BuildFailed(built.output);
    return verdict_on_build(*error);
  }
  RunLimits limits;
  limits.is_memory_limited = !has_sanitizer(home_.workspace);
  const AnswerRun run = run_answer(exercise, built_program(home_.workspace, target), limits);
  return verdict_on_run(exercise, run.result, run.output, limits.seconds);
}

}  // namespace lt
