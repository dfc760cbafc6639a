#include "tests/house/snippets.hpp"

#include "common/testkit/catch.hpp"
#include "tests/house/planted.hpp"

using namespace lt::house;

namespace {

const std::string text = "chapters/ch01_dots/README.md";
const std::string comment = "<!-- snippet: dot.hpp dot -->";

Findings found_after(const std::string& file, const std::string& find, const std::string& by) {
  PlantedProject project;
  plant_complete_project(project);
  project.replace("chapters/ch01_dots/" + file, find, by);
  return check_snippets(project.tree());
}

// What is out of place in the planted text stands at the fence or at the comment above it.
void check_one(const Findings& findings) {
  INFO(to_string(findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].file == text);
  CHECK((findings[0].line == 326 || findings[0].line == 327));
}

}  // namespace

TEST_CASE("snippets: a complete project has nothing out of place") {
  PlantedProject project;
  plant_complete_project(project);
  CHECK(check_snippets(project.tree()) == Findings{});
}

TEST_CASE("snippets: an edit of the text is found") {
  check_one(found_after("README.md", "int dot();", "int dot(int);"));
}

TEST_CASE("snippets: an edit of the code is found") {
  check_one(found_after("dot.hpp", "int dot();", "long dot();"));
}

TEST_CASE("snippets: a file or a tag that is not there is found") {
  check_one(found_after("README.md", comment, "<!-- snippet: line.hpp dot -->"));
  check_one(found_after("README.md", comment, "<!-- snippet: dot.hpp line -->"));
}

TEST_CASE("snippets: code that does not say where it is from is found") {
  check_one(found_after("README.md", comment, ""));
  check_one(found_after("README.md", comment, "<!-- not compiled: -->"));
  CHECK(found_after("README.md", comment, "<!-- not compiled: shows the mistake -->").empty());
}

TEST_CASE("snippets: a piece of more than 30 lines is found") {
  const auto with_lines = [](int count) {
    std::string code;
    for (int i = 0; i < count; ++i)
      code += "int a" + std::to_string(i) + ";\n";
    PlantedProject project;
    plant_complete_project(project);
    project.replace("chapters/ch01_dots/dot.hpp", "int dot();\n", code);
    project.replace(text, "int dot();\n", code);
    return check_snippets(project.tree());
  };
  CHECK(with_lines(30).empty());
  check_one(with_lines(31));
}
