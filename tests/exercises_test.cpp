#include "tests/house/exercises.hpp"

#include "common/testkit/catch.hpp"
#include "tests/house/planted.hpp"

using namespace lt::house;

namespace {

const std::string folder = "exercises/ch01_dots/count/";
const std::string json = folder + "exercise.json";

Findings found_after(const std::string& file, const std::string& find, const std::string& by) {
  PlantedProject project;
  plant_complete_project(project);
  project.replace(file, find, by);
  return check_exercises(project.tree());
}

}  // namespace

TEST_CASE("exercises: a complete project has nothing out of place") {
  PlantedProject project;
  plant_complete_project(project);
  CHECK(check_exercises(project.tree()) == Findings{});
}

TEST_CASE("exercises: each of the seven files is missed when it is gone") {
  for (const std::string name : {"exercise.json", "api.hpp", "starter.cpp", "test.cpp",
                                 "solution.cpp", "other.cpp", "README.md"}) {
    PlantedProject project;
    plant_complete_project(project);
    project.remove(folder + name);
    CHECK(check_exercises(project.tree()) == Findings{{folder + name, 0, "is missing"}});
  }
}

TEST_CASE("exercises: an exercise.json that the runner refuses is found") {
  CHECK(found_after(json, "\"count\"", "\"counting\"").size() == 1);
  CHECK(found_after(json, "01.1", "02.7").size() == 1);
  CHECK(found_after(json, ", \"How?\"", "").size() == 1);
  CHECK(found_after(json, "minutes", "minuets").size() == 1);
  CHECK(found_after(json, "}", "").size() == 1);
}

TEST_CASE("exercises: an id that another exercise has is found") {
  PlantedProject project;
  plant_complete_project(project);
  const Tree tree = project.tree();
  for (const std::string& name : tree.files_in(folder)) {
    project.write("exercises/ch01_dots/again/" + name.substr(folder.size()), tree.text(name));
  }
  project.replace("exercises/ch01_dots/again/exercise.json", "\"count\"", "\"again\"");
  project.replace("chapters/ch01_dots/README.md", "## Read on",
                  "[a](../../exercises/ch01_dots/again/README.md)\n\n## Read on");
  CHECK(check_exercises(project.tree()) == Findings{{json, 0, "id 01.1 is used twice"}});
}

TEST_CASE("exercises: a mutant that the solution does not hold exactly once is found") {
  CHECK(found_after(json, "\"+ 1\"", "\"+ 9\"").size() == 1);
  CHECK(found_after(folder + "solution.cpp", "a + 1;", "a + 1 + 1;").size() == 1);
}

TEST_CASE("exercises: a mutant that the test never diagnoses is found") {
  CHECK(found_after(folder + "test.cpp", "\"off-by-one\"", "\"off\"") ==
        Findings{{json, 0, "mutant \"off-by-one\": is never diagnosed in test.cpp"}});
}

TEST_CASE("exercises: a test may keep what it compares with in formulas.hpp") {
  PlantedProject project;
  plant_complete_project(project);
  project.replace(folder + "test.cpp", "\"off-by-one\"", "mistake");
  project.write(folder + "formulas.hpp", "const char* const mistake = \"off-by-one\";\n");
  CHECK(check_exercises(project.tree()) == Findings{});
}

TEST_CASE("exercises: a starter without a TODO is found") {
  CHECK(found_after(folder + "starter.cpp", "TODO(", "todo(") ==
        Findings{{folder + "starter.cpp", 0, "has no TODO(...)"}});
}

TEST_CASE("exercises: an exercise that its chapter does not link to is found") {
  CHECK(found_after("chapters/ch01_dots/README.md", "count/README.md", "count") ==
        Findings{{"chapters/ch01_dots/README.md", 0,
                  "does not link to exercises/ch01_dots/count/README.md"}});
}
