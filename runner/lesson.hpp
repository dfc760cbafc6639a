/// @file
/// One sitting with the exercises: which there are, which is open, how each stands, and the check
/// of an answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/exercise.hpp"
#include "runner/progress_file.hpp"
#include "runner/verdict.hpp"
#include "runner/workspace.hpp"

namespace lt {

/// How an exercise stands.
enum class State {
  not_opened,
  not_started,
  unchecked,  ///< the learner's file has not been checked, as far as is remembered
  not_yet,
  done,
  check_again,  ///< was done; since then the file or its test has changed
};

[[nodiscard]] std::string in_words(State state);

/// What the commands and the watch work with.
class Lesson {
 public:
  /// @throws InputError  an exercise.json is broken, or there is none at all
  explicit Lesson(Home home);

  [[nodiscard]] const std::vector<Exercise>& exercises() const { return exercises_; }
  [[nodiscard]] const Workspace& workspace() const { return workspace_; }
  [[nodiscard]] const ProgressFile& progress() const { return progress_; }
  [[nodiscard]] const Home& home() const { return home_; }

  /// The exercise that is open; the first that is not done if none is.
  [[nodiscard]] const Exercise& current() const;
  void set_current(const Exercise& exercise) const;
  /// The next exercise behind this one that is not done, starting over at the end; nothing if all
  /// are done.
  [[nodiscard]] const Exercise* next_after(const Exercise& exercise) const;

  [[nodiscard]] Record record(const Exercise& exercise) const;
  void change_record(const Exercise& exercise, const std::function<void(Record&)>& edit) const;
  [[nodiscard]] State state(const Exercise& exercise) const;
  [[nodiscard]] int done_count() const;

  /// Builds and runs the learner's answer, and remembers how it went.
  /// @throws BuildFailed  something else than the learner's file does not build
  Verdict check(const Exercise& exercise) const;

  /// A number that changes when the learner's file does; "" while it is not there.
  [[nodiscard]] std::string answer_fingerprint(const Exercise& exercise) const;

  /// The same for what checks it, test.cpp and api.hpp; "" while they are not there.
  [[nodiscard]] std::string test_fingerprint(const Exercise& exercise) const;

 private:
  [[nodiscard]] Verdict build_and_run(const Exercise& exercise, const std::string& answer) const;

  Home home_;
  std::vector<Exercise> exercises_;
  Workspace workspace_;
  ProgressFile progress_;
};

}  // namespace lt
