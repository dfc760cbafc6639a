// The rules of the house, held against the project itself. What each check finds is shown to work
// on planted projects, in the other tests of this folder.
#include "common/testkit/catch.hpp"
#include "tests/house/chapters.hpp"
#include "tests/house/exercises.hpp"
#include "tests/house/figures.hpp"
#include "tests/house/includes.hpp"
#include "tests/house/links.hpp"
#include "tests/house/names.hpp"
#include "tests/house/snippets.hpp"
#include "tests/house/words.hpp"

using namespace lt::house;

namespace {

const Tree& project() {
  static const Tree tree(LT_ROOT);
  return tree;
}

void check_empty(const Findings& findings) {
  INFO(to_string(findings));
  CHECK(findings.empty());
}

}  // namespace

TEST_CASE("the house: includes point backwards only") {
  check_empty(check_includes(project()));
}

TEST_CASE("the house: every chapter is complete") {
  check_empty(check_chapters(project()));
}

TEST_CASE("the house: every exercise is complete") {
  check_empty(check_exercises(project()));
}

TEST_CASE("the house: every link leads somewhere") {
  check_empty(check_links(project()));
}

TEST_CASE("the house: every figure is made, stored and shown") {
  check_empty(check_figures(project()));
}

TEST_CASE("the house: texts show the code that is compiled") {
  check_empty(check_snippets(project()));
}

TEST_CASE("the house: names and shapes of files") {
  check_empty(check_names(project()));
}

TEST_CASE("the house: no text speaks of one machine") {
  check_empty(check_words(project()));
}

TEST_CASE("the house: there is something to check") {
  CHECK(chapters_of(project()).size() >= 3);
  CHECK(project().files_in("exercises/", "/exercise.json").size() >= 9);
}
