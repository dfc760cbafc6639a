#include "tests/house/chapters.hpp"

#include <string>

#include "common/testkit/catch.hpp"
#include "tests/house/planted.hpp"

using namespace lt::house;

namespace {

const std::string chapter = "chapters/ch01_dots/";
const std::string text = chapter + "README.md";

// What the check finds once `find` in chapter 1's text is replaced.
Findings found_after(const std::string& find, const std::string& by) {
  PlantedProject project;
  plant_complete_project(project);
  project.replace(text, find, by);
  return check_chapters(project.tree());
}

Findings found_without(const std::string& file) {
  PlantedProject project;
  plant_complete_project(project);
  project.remove(file);
  return check_chapters(project.tree());
}

}  // namespace

TEST_CASE("chapters: a complete project has nothing out of place") {
  PlantedProject project;
  plant_complete_project(project);
  CHECK(check_chapters(project.tree()) == Findings{});
}

TEST_CASE("chapters: a missing text, program, test, exercise or list of pictures is found") {
  CHECK(found_without(text) == Findings{{text, 0, "is missing"}});
  CHECK(found_without(chapter + "main.cpp") == Findings{{chapter + "main.cpp", 0, "is missing"}});
  CHECK(found_without(chapter + "tests/dot_test.cpp") ==
        Findings{{chapter + "tests", 0, "has no test"}});
  CHECK(found_without("exercises/ch01_dots/count/exercise.json") ==
        Findings{{"exercises/ch01_dots", 0, "has no exercise"}});
  CHECK(found_without(chapter + "pictures.json") ==
        Findings{{chapter + "pictures.json", 0, "is missing"}});
}

TEST_CASE("chapters: a chapter that stores no picture is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.replace(chapter + "pictures.json", ", \"stored\": {\"width\": 8, \"height\": 4}", "");
  CHECK(check_chapters(project.tree()) ==
        Findings{{chapter + "pictures.json", 0, "stores no picture for the text"}});
}

TEST_CASE("chapters: pictures.json that is broken, misspelt or repeats itself is found") {
  const auto found_with = [](const std::string& json) {
    PlantedProject project;
    plant_complete_project(project);
    project.write(chapter + "pictures.json", json);
    return check_chapters(project.tree());
  };
  const std::string entry = R"({"file": "a.png", "caption": "A.", "args": [], "stored": {}})";
  CHECK(found_with("[" + entry + "]").empty());
  CHECK(found_with("[" + entry + ", " + entry + "]").size() == 1);
  CHECK_FALSE(found_with("[" + entry).empty());
  CHECK(found_with("[" + entry + R"(, {"file": "b.png", "args": []}])").size() == 1);
  CHECK(found_with("[" + entry + R"(, {"file": "b.png", "caption": "", "args": [], "hight": 2}])")
            .size() == 1);
}

TEST_CASE("chapters: a title with another number is found") {
  CHECK(found_after("# 1. A chapter", "# 2. A chapter") ==
        Findings{{text, 1, "starts with its one title, \"# 1. ...\""}});
}

TEST_CASE("chapters: an opening without its picture or one of its lines is found") {
  CHECK(found_after("![What to see](figures/first.png)", "") ==
        Findings{{text, 1, "opens without the picture it ends with"}});
  CHECK(found_after("Builds on", "Stands on") ==
        Findings{{text, 1, "the opening lacks \"Builds on\""}});
}

TEST_CASE("chapters: a part that is missing, new or out of its order is found") {
  CHECK(found_after("## The maths", "### The maths") ==
        Findings{{text, 324, "expected the part \"The maths\", found \"The code\""}});
  CHECK(found_after("## Next", "## Credits\n\n## Next").size() == 1);
  CHECK(found_after("## Look\n\n## Does it hold?", "## Does it hold?\n\n## Look").size() == 1);
}

TEST_CASE("chapters: a text that is too short or too long is found") {
  const std::string sentence = "Five words make a line.\n";
  std::string many;
  for (int i = 0; i < 400; ++i)
    many += sentence;
  CHECK(found_after(sentence, many).size() == 1);
  PlantedProject project;
  plant_complete_project(project);
  for (int i = 0; i < 60; ++i)
    project.replace(text, sentence, "");
  CHECK(check_chapters(project.tree()).size() == 1);
}

TEST_CASE("chapters: a program of more than 80 lines is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.write(chapter + "main.cpp", std::string(80, '\n'));
  CHECK(check_chapters(project.tree()).empty());
  project.write(chapter + "main.cpp", std::string(81, '\n'));
  CHECK(check_chapters(project.tree()).size() == 1);
}

TEST_CASE("chapters: a chapter that no table of contents lists is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.replace("chapters/README.md", "ch02_lines/README.md", "ch01_dots/README.md");
  CHECK(check_chapters(project.tree()) ==
        Findings{{"chapters/README.md", 0, "does not link to ch02_lines/README.md"}});
}
