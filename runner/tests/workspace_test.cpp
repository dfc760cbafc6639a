#include "runner/workspace.hpp"

#include "common/error.hpp"
#include "common/testkit/catch.hpp"
#include "runner/tests/toy_course.hpp"

using namespace lt;
using lt::test::ToyCourse;

namespace {

struct Desk {
  ToyCourse course;
  Lesson lesson{course.home()};
  const Exercise& exercise = lesson.exercises().front();
  const Workspace& workspace = lesson.workspace();

  Opened open() const { return workspace.open(exercise, course.home().workspace); }
  [[nodiscard]] std::string answer() const { return read_file(course.answer()); }
  void write(const std::string& text) const { write_file_whole(course.answer(), text); }
  [[nodiscard]] std::string starter() const { return read_file(course.file("starter.cpp")); }
};

const std::string written = "double halve(double x) {\n  return x / 2;\n}";
const std::string unwritten = "double halve(double /*x*/) {\n  TODO(\"return half of x\");\n}";

}  // namespace

TEST_CASE("workspace: opening makes the file from the starter, once") {
  const Desk desk;
  CHECK(desk.open() == Opened::created);
  CHECK(desk.answer() == desk.starter());
  CHECK(desk.workspace.is_untouched(desk.exercise));
  desk.write("mine");
  CHECK(desk.open() == Opened::as_it_was);
  CHECK(desk.answer() == "mine");
  CHECK_FALSE(desk.workspace.is_untouched(desk.exercise));
}

TEST_CASE("workspace: an untouched file follows the starter") {
  const Desk desk;
  (void)desk.open();
  ToyCourse::replace(desk.course.file("starter.cpp"), "half of x", "x / 2");
  CHECK(desk.open() == Opened::updated);
  CHECK(desk.answer() == desk.starter());
}

TEST_CASE("workspace: a merge keeps the learner's lines and brings the starter's") {
  const Desk desk;
  (void)desk.open();
  ToyCourse::replace(desk.course.answer(), unwritten, written);
  const std::string before = desk.answer();
  ToyCourse::replace(desk.course.file("starter.cpp"), "\n\n", "\n#include <cmath>\n\n");
  CHECK(desk.open() == Opened::starter_changed);
  CHECK(desk.answer() == before);  // nothing happens unasked

  REQUIRE(desk.workspace.merge(desk.exercise) == Merged::cleanly);
  CHECK(desk.answer().find("#include <cmath>") != std::string::npos);
  CHECK(desk.answer().find(written) != std::string::npos);
  CHECK(read_file(desk.course.my() / ".saved" / "00.1-halve.1.cpp") == before);
  CHECK(desk.open() == Opened::as_it_was);
}

TEST_CASE("workspace: where both changed the same line the learner's file stays as it is") {
  const Desk desk;
  (void)desk.open();
  ToyCourse::replace(desk.course.answer(), unwritten, written);
  const std::string before = desk.answer();
  ToyCourse::replace(desk.course.file("starter.cpp"), "half of x", "x / 2");
  CHECK(desk.workspace.merge(desk.exercise) == Merged::conflict);
  CHECK(desk.answer() == before);
  CHECK(desk.open() == Opened::starter_changed);
}

TEST_CASE("workspace: a reset saves the old file, each time under a new name") {
  const Desk desk;
  CHECK_THROWS_AS(desk.workspace.reset(desk.exercise), InputError);  // not opened yet
  (void)desk.open();
  for (const std::string text : {"one", "two"}) {
    desk.write(text);
    const auto saved = desk.workspace.reset(desk.exercise);
    CHECK(read_file(saved) == text);
    CHECK(desk.answer() == desk.starter());
  }
  CHECK(read_file(desk.course.my() / ".saved" / "00.1-halve.1.cpp") == "one");
}
