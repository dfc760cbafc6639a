// The program itself, as a learner uses it, with a toy exercise. One story, because the first check
// compiles the test kit: half a minute.
#include "common/testkit/catch.hpp"
#include "runner/process.hpp"
#include "runner/tests/terminal_program.hpp"
#include "runner/tests/toy_course.hpp"

using namespace lt;
using lt::test::ToyCourse;

namespace {

using Words = std::vector<std::string>;

std::vector<std::pair<std::string, std::string>> environment(const ToyCourse& course) {
  return {{"LT_MY", course.home().my.string()},
          {"LT_EXERCISES", course.home().exercises.string()},
          {"NO_COLOR", "1"},
          {"TERM", "xterm"}};
}

ProcessResult learn(const ToyCourse& course, const Words& words) {
  Words command{LT_LEARN};
  command.insert(command.end(), words.begin(), words.end());
  ProcessOptions options;
  options.environment = environment(course);
  return run_process(command, options);
}

// What `words` prints; it must end with this code.
std::string said(const ToyCourse& course, const Words& words, int exit_code) {
  const ProcessResult result = learn(course, words);
  INFO(result.output);
  CHECK(result.exit_code == exit_code);
  return result.output;
}

bool has(const std::string& text, const std::string& part) {
  UNSCOPED_INFO(text);
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("learner: from the starter to done, and what happens when the course changes") {
  const ToyCourse course;
  CHECK(has(said(course, {"list"}, 0), "not opened"));
  CHECK(has(said(course, {"run"}, 1), "TODO: return half of x"));
  CHECK(has(said(course, {"hint"}, 0), "hint 1 of 3"));
  CHECK(has(said(course, {"hint", "halve"}, 0), "hint 2 of 3"));
  CHECK(has(said(course, {"solution"}, 1), "not done yet"));
  CHECK(has(said(course, {"solution", "--anyway"}, 0), "return x / 2;"));

  const std::string solution = read_file(course.file("solution.cpp"));
  write_file_whole(course.answer(), solution);
  ToyCourse::replace(course.answer(), "x / 2", "x * 2");
  CHECK(has(said(course, {"run"}, 1), "You double the number; it ought to shrink."));
  write_file_whole(course.answer(), solution);
  CHECK(has(said(course, {"run"}, 0), "Every check holds."));
  CHECK(has(said(course, {"next"}, 0), "Every exercise is done."));
  CHECK(has(said(course, {"run", "--merge"}, 0), "nothing to merge"));

  ToyCourse::replace(course.file("test.cpp"), "half of 6", "half of six");
  CHECK(has(said(course, {"list"}, 0), "check again"));
  CHECK(has(said(course, {"verify"}, 0), "1 of 1 done"));

  ToyCourse::replace(course.file("starter.cpp"), "\n\n", "\n#include <cmath>\n\n");
  CHECK(has(said(course, {"run"}, 0), "--merge merges the new starter"));
  CHECK(has(said(course, {"run", "--merge"}, 0), "Merged."));
  CHECK(has(read_file(course.answer()), "#include <cmath>"));

  write_file_whole(course.my() / "progress.json", "{ broken");
  CHECK(has(said(course, {"list"}, 0), "is made anew from your files"));
  CHECK(has(said(course, {"list"}, 0), "1 of 1 done"));

#ifndef _WIN32  // it has no terminals that a program can pretend to be
  lt::test::TerminalProgram watch({LT_LEARN}, environment(course));
  CHECK(watch.shows("Every check holds."));
  ToyCourse::replace(course.answer(), "x / 2", "x * 2");
  CHECK(watch.shows("You double the number"));
  watch.press('s');
  CHECK(watch.shows("The solution opens when your answer is done."));
  watch.press('h');
  CHECK(watch.shows("hint 1 of 3"));
  ToyCourse::replace(course.answer(), "x * 2", "x / 2");
  CHECK(watch.shows("Every check holds."));
  ToyCourse::replace(course.file("test.cpp"), "half == 3", "half == 4");
  CHECK(watch.shows("This does not hold yet"));
  watch.press('r');
  CHECK(watch.shows("y/n"));
  watch.press('y');
  CHECK(watch.shows("This is expected"));
  watch.press('q');
  CHECK(watch.exit_code() == 0);
  INFO(watch.screen());
  CHECK(watch.screen().ends_with("\x1b[?25h"));  // the cursor is back
#endif
}
