#include "runner/lesson.hpp"

#include <functional>

#include "common/error.hpp"
#include "common/testkit/catch.hpp"
#include "runner/tests/toy_course.hpp"
#include "runner/watch.hpp"

using namespace lt;
using lt::test::ToyCourse;

namespace {

// As if the exercise had been checked and were done.
void remember_done(const Lesson& lesson, const Exercise& exercise) {
  lesson.change_record(exercise, [&](Record& record) {
    record.is_done = true;
    record.answer = lesson.answer_fingerprint(exercise);
    record.test = lesson.test_fingerprint(exercise);
  });
}

std::string complaint(const std::function<void()>& work) {
  try {
    work();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("lesson: done becomes check again when the test, the api or the answer changes") {
  for (const std::string what : {"test.cpp", "api.hpp", "formulas.hpp", "the answer"}) {
    const ToyCourse course;
    if (what == "formulas.hpp") write_file_whole(course.file(what), "");
    const Lesson lesson(course.home());
    const Exercise& exercise = lesson.exercises().front();
    CHECK(lesson.state(exercise) == State::not_opened);
    (void)lesson.workspace().open(exercise, course.home().workspace);
    CHECK(lesson.state(exercise) == State::not_started);
    remember_done(lesson, exercise);
    CHECK(lesson.state(exercise) == State::done);
    CHECK(lesson.done_count() == 1);

    const auto changed = what == "the answer" ? course.answer() : course.file(what);
    write_file_whole(changed, read_file(changed) + "\n");
    INFO(what);
    CHECK(lesson.state(exercise) == State::check_again);
    CHECK(lesson.done_count() == 0);
  }
}

TEST_CASE("lesson: a file that an update is replacing is no error") {
  const ToyCourse course;
  const Lesson lesson(course.home());
  const Exercise& exercise = lesson.exercises().front();
  (void)lesson.workspace().open(exercise, course.home().workspace);
  remember_done(lesson, exercise);
  std::filesystem::remove(course.file("test.cpp"));
  CHECK(lesson.state(exercise) == State::check_again);
}

TEST_CASE("lesson: each missing file of an exercise is named with the way to get it back") {
  for (const std::string name :
       {"api.hpp", "starter.cpp", "test.cpp", "solution.cpp", "README.md"}) {
    const ToyCourse course;
    const auto load = [&] { (void)load_exercises(course.home()); };
    CHECK(complaint(load).empty());
    std::filesystem::remove(course.file(name));
    const std::string said = complaint(load);
    INFO(said);
    CHECK(said.find(name + " is missing") != std::string::npos);
    CHECK(said.find("git checkout -- ") != std::string::npos);
    CHECK(said.find('\n') == std::string::npos);
  }
}

TEST_CASE("lesson: an exercise is found by number or name, or a near one is named") {
  const ToyCourse course;
  const Lesson lesson(course.home());
  for (const std::string word : {"00.1", "0.1", "halve", "00.1-halve"})
    CHECK(find_exercise(lesson.exercises(), word).id == "00.1");
  CHECK(complaint([&] { (void)find_exercise(lesson.exercises(), "havle"); }) ==
        "no exercise havle: did you mean halve?");
  CHECK(complaint([&] { (void)find_exercise(lesson.exercises(), "99.9"); }) ==
        "no exercise 99.9; ./learn list shows them all");
}

TEST_CASE("watcher: tells of a change once, of the answer and of its test, and of nothing else") {
  const ToyCourse course;
  const Lesson lesson(course.home());
  const Exercise& exercise = lesson.exercises().front();
  Watcher watcher;
  const auto has_changed = [&] { return watcher.has_changed(lesson, exercise); };
  CHECK_FALSE(has_changed());  // not there yet
  (void)lesson.workspace().open(exercise, course.home().workspace);
  CHECK(has_changed());  // the first time
  CHECK_FALSE(has_changed());

  write_file_whole(course.answer(), "new");
  CHECK(has_changed());
  write_file_whole(course.answer(), "new");  // saved again, the same
  CHECK_FALSE(has_changed());

  ToyCourse::replace(course.file("test.cpp"), "half of 6", "half of six");
  CHECK(has_changed());
  CHECK_FALSE(has_changed());

  // Some editors move the old file away before they write the new one.
  for (const auto& file : {course.answer(), course.file("test.cpp")}) {
    const std::string text = read_file(file);
    std::filesystem::remove(file);
    CHECK_FALSE(has_changed());
    write_file_whole(file, text);
    CHECK_FALSE(has_changed());
  }
}
