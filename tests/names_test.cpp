#include "tests/house/names.hpp"

#include "common/testkit/catch.hpp"
#include "tests/house/planted.hpp"

using namespace lt::house;

namespace {

std::size_t findings_with(const std::string& name, const std::string& text = "\n") {
  PlantedProject project;
  plant_complete_project(project);
  project.write(name, text);
  return check_names(project.tree()).size();
}

}  // namespace

TEST_CASE("names: a complete project has nothing out of place") {
  PlantedProject project;
  plant_complete_project(project);
  CHECK(check_names(project.tree()) == Findings{});
}

TEST_CASE("names: files that are named in another way are found") {
  CHECK(findings_with("common/two_words.cpp") == 0);
  CHECK(findings_with("common/TwoWords.cpp") == 1);
  CHECK(findings_with("common/two-words.cpp") == 1);
  CHECK(findings_with("common/two_words.cc") == 1);
  CHECK(findings_with("common/tests/two_words.cpp") == 1);
  CHECK(findings_with("common/tests/two_words_test.cpp") == 0);
  CHECK(findings_with("chapters/three/README.md") == 1);
  CHECK(findings_with("chapters/ch01_dots/figures/two_words.svg") == 1);
  CHECK(findings_with("exercises/ch01_dots/two_words/README.md") == 1);
}

TEST_CASE("names: a file that is too long to read gladly is found") {
  CHECK(findings_with("chapters/ch01_dots/main.cpp", std::string(200, '\n')) == 0);
  CHECK(findings_with("chapters/ch01_dots/main.cpp", std::string(201, '\n')) == 1);
  CHECK(findings_with("common/long.cpp", std::string(250, '\n')) == 0);
  CHECK(findings_with("common/long.cpp", std::string(251, '\n')) == 1);
  const std::string table =
      "// clang-format off\n" + std::string(99, '\n') + "// clang-format on\n";
  CHECK(findings_with("common/long.cpp", table + std::string(249, '\n')) == 0);
  CHECK(findings_with("common/long.cpp", table + std::string(250, '\n')) == 1);
}

TEST_CASE("names: a semicolon in a test's name is found") {
  const std::string file = "common/tests/a_test.cpp";
  CHECK(findings_with(file, "TEST_CASE(\"a: one, two\") {\n  int a;\n}\n") == 0);
  CHECK(findings_with(file, "TEST_CASE(\"a: one; two\") {\n}\n") == 1);
  CHECK(findings_with(file, "TEST_CASE(\n    \"a: one; two\") {\n}\n") == 1);
}

TEST_CASE("names: a header without its guard is found") {
  CHECK(findings_with("common/a.hpp", "/// @file\n/// Why.\n#pragma once\n") == 0);
  CHECK(findings_with("common/a.hpp", "#include <vector>\n#pragma once\n") == 1);
}

TEST_CASE("names: tabs, loose blanks, carriage returns and missing newlines are found") {
  CHECK(findings_with("common/a.cpp", "int a;\t// a\n") == 1);
  CHECK(findings_with("common/a.cpp", "int a; \n") == 1);
  CHECK(findings_with("common/a.cpp", "int a;\r\n") == 1);
  CHECK(findings_with("common/a.cpp", "int a;") == 1);
}
