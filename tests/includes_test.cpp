#include "tests/house/includes.hpp"

#include "common/testkit/catch.hpp"
#include "tests/house/planted.hpp"

using namespace lt::house;

namespace {

const std::string dot = "chapters/ch01_dots/dot.hpp";
const std::string line = "chapters/ch02_lines/dot.hpp";

// What the check finds once `file` includes `name`.
Findings found_with(const std::string& file, const std::string& name) {
  PlantedProject project;
  plant_complete_project(project);
  project.write(file, "#pragma once\n#include " + name + "\n");
  return check_includes(project.tree());
}

}  // namespace

TEST_CASE("includes: what a chapter stands on follows USES from chapter to chapter") {
  PlantedProject project;
  plant_complete_project(project);
  project.write("chapters/ch03_planes/CMakeLists.txt",
                "lt_chapter(ch03_planes\n  USES ch02_lines)\n");
  const Uses uses = read_uses(project.tree());
  CHECK(uses.at("ch01_dots") == std::set<std::string>{"ch01_dots"});
  CHECK(uses.at("ch03_planes") == std::set<std::string>{"ch01_dots", "ch02_lines", "ch03_planes"});
}

TEST_CASE("includes: pointing backwards is right") {
  CHECK(found_with(line, "\"ch01_dots/dot.hpp\"") == Findings{});
  CHECK(found_with(line, "\"common/files.hpp\"") == Findings{});
  CHECK(found_with(line, "<glm/glm.hpp>") == Findings{});
}

TEST_CASE("includes: a planted forward include is found") {
  CHECK(found_with(dot, "\"ch02_lines/dot.hpp\"") ==
        Findings{{dot, 2,
                  "\"ch02_lines/dot.hpp\": points forward: ch01_dots must not know of "
                  "ch02_lines"}});
}

TEST_CASE("includes: a chapter that is not among the USES is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.write("chapters/ch02_lines/CMakeLists.txt", "lt_chapter(ch02_lines)\n");
  project.write(line, "#include \"ch01_dots/dot.hpp\"\n");
  CHECK(check_includes(project.tree()) ==
        Findings{{line, 1,
                  "\"ch01_dots/dot.hpp\": ch01_dots is not among the USES of ch02_lines "
                  "(chapters/ch02_lines/CMakeLists.txt)"}});
}

TEST_CASE("includes: a chapter that uses a later one is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.write("chapters/ch01_dots/CMakeLists.txt", "lt_chapter(ch01_dots USES ch02_lines)\n");
  CHECK(check_includes(project.tree()) ==
        Findings{{"chapters/ch01_dots/CMakeLists.txt", 0,
                  "points forward: ch01_dots must not use ch02_lines"}});
}

TEST_CASE("includes: a chapter declared under another name than its folder is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.write("chapters/ch01_dots/CMakeLists.txt", "lt_chapter(ch01_spots)\n");
  CHECK(check_includes(project.tree()) ==
        Findings{{"chapters/ch01_dots/CMakeLists.txt", 0,
                  "one name everywhere: declare lt_chapter(ch01_dots ...)"}});
}

TEST_CASE("includes: relative and bare names are found") {
  CHECK(found_with(line, "\"../ch01_dots/dot.hpp\"").size() == 1);
  CHECK(found_with(line, "\"ch02_lines/../ch01_dots/dot.hpp\"").size() == 1);
  CHECK(found_with(line, "\"dot.hpp\"").size() == 1);
  CHECK(found_with(line, "<ch01_dots/dot.hpp>").size() == 1);
}

TEST_CASE("includes: common/ knows no chapter and no runner") {
  CHECK(found_with("common/files.hpp", "\"ch01_dots/dot.hpp\"").size() == 1);
  CHECK(found_with("common/files.hpp", "\"runner/door.hpp\"").size() == 1);
  CHECK(found_with("common/files.hpp", "\"common/error.hpp\"").empty());
}

TEST_CASE("includes: the test kit stays in tests") {
  CHECK(found_with(dot, "\"common/testkit/catch.hpp\"").size() == 1);
  CHECK(found_with(dot, "\"common/testkit/statistics.hpp\"").empty());  // measures its own noise
  CHECK(found_with(dot, "\"common/testkit/sampler_test.hpp\"").empty());
  CHECK(found_with("common/files.hpp", "\"common/testkit/statistics.hpp\"").size() == 1);
  CHECK(found_with("chapters/ch01_dots/tests/a_test.cpp", "\"common/testkit/statistics.hpp\"")
            .empty());
  CHECK(found_with("chapters/ch01_dots/tests/a_test.cpp", "<catch2/catch.hpp>").size() == 1);
}

TEST_CASE("includes: an exercise sees its api and the kit only") {
  const std::string folder = "exercises/ch01_dots/count/";
  CHECK(found_with(folder + "solution.cpp", "\"api.hpp\"").empty());
  CHECK(found_with(folder + "solution.cpp", "\"ch01_dots/dot.hpp\"").size() == 1);
  CHECK(found_with(folder + "solution.cpp", "\"common/testkit/exercise.hpp\"").size() == 1);
  CHECK(found_with(folder + "solution.cpp", "\"common/testkit/statistics.hpp\"").size() == 1);
  CHECK(found_with(folder + "solution.cpp", "\"formulas.hpp\"").size() == 1);
  CHECK(found_with(folder + "test.cpp", "\"formulas.hpp\"").empty());
  CHECK(found_with(folder + "test.cpp", "\"other.hpp\"").size() == 1);
  CHECK(found_with(folder + "formulas.hpp", "\"common/testkit/exercise.hpp\"").empty());
  CHECK(found_with(folder + "formulas.hpp", "\"ch01_dots/dot.hpp\"").size() == 1);
  CHECK(found_with(folder + "test.cpp", "\"common/testkit/exercise.hpp\"").empty());
  CHECK(found_with(folder + "test.cpp", "\"common/testkit/hemisphere.hpp\"").empty());
  CHECK(found_with(folder + "test.cpp", "\"common/testkit/statistics.hpp\"").empty());
  CHECK(found_with("runner/tests/data/" + folder + "test.cpp", "\"api.hpp\"").empty());
}

TEST_CASE("includes: the runner knows no chapter") {
  CHECK(found_with("runner/door.hpp", "\"ch01_dots/dot.hpp\"").size() == 1);
  CHECK(found_with("runner/door.hpp", "\"common/files.hpp\"").empty());
}
