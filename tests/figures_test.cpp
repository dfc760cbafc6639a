#include "tests/house/figures.hpp"

#include "common/testkit/catch.hpp"
#include "tests/house/planted.hpp"

using namespace lt::house;

namespace {

const std::string figures = "chapters/ch01_dots/figures/";
const std::string text = "chapters/ch01_dots/README.md";

}  // namespace

TEST_CASE("figures: a complete project has nothing out of place") {
  PlantedProject project;
  plant_complete_project(project);
  CHECK(check_figures(project.tree()) == Findings{});
}

TEST_CASE("figures: a picture that no command makes is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.write(figures + "found.png", "from somewhere");
  project.replace(text, "## Look", "![Found](figures/found.png)\n\n## Look");
  CHECK(check_figures(project.tree()) ==
        Findings{{figures + "found.png", 0, "has no entry with \"stored\" in pictures.json"}});
}

TEST_CASE("figures: a figure that no page shows is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.write(figures + "forgotten.svg", "<svg/>\n");
  CHECK(check_figures(project.tree()) ==
        Findings{{figures + "forgotten.svg", 0, "is shown by no page"}});
}

TEST_CASE("figures: a stored picture that is not there is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.remove(figures + "first.png");
  CHECK(check_figures(project.tree()) ==
        Findings{{figures + "first.png", 0, "is listed as stored but is not there"}});
}

TEST_CASE("figures: a file of more than 200 KB is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.write(figures + "drawing.svg", std::string(200 * 1024, ' '));
  CHECK(check_figures(project.tree()).empty());
  project.write(figures + "drawing.svg", std::string(200 * 1024 + 1, ' '));
  CHECK(check_figures(project.tree()) ==
        Findings{{figures + "drawing.svg", 0, "is larger than 200 KB"}});
}

TEST_CASE("figures: a made picture without its command is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.replace(text, "--view first", "--view last");
  CHECK(check_figures(project.tree()) ==
        Findings{{text, 3, "no `./learn chapter 1 --view first` below its picture"}});
}

TEST_CASE("figures: an arrow that the drawing of the chain lacks is found") {
  PlantedProject project;
  plant_complete_project(project);
  project.replace("chapters/figures/chain.svg", "ch01_dots-to-ch02_lines", "ch01_dots");
  CHECK(check_figures(project.tree()) ==
        Findings{{"chapters/figures/chain.svg", 0, "has no arrow ch01_dots-to-ch02_lines"}});
}
