#include "tests/house/links.hpp"

#include "common/testkit/catch.hpp"
#include "tests/house/planted.hpp"

using namespace lt::house;

namespace {

const std::string page = "chapters/ch02_lines/README.md";

// What the check finds once `text` stands at the top of chapter 2.
Findings found_with(const std::string& text) {
  PlantedProject project;
  plant_complete_project(project);
  project.write(page, text + "\n\n## A heading\n\n## A heading\n");
  return check_links(project.tree());
}

}  // namespace

TEST_CASE("links: a complete project has nothing out of place") {
  PlantedProject project;
  plant_complete_project(project);
  CHECK(check_links(project.tree()) == Findings{});
}

TEST_CASE("links: pages, files, folders, anchors and lines that are there are right") {
  CHECK(found_with("[a](../ch01_dots/README.md)") == Findings{});
  CHECK(found_with("[a](../ch01_dots/README.md#the-problem)") == Findings{});
  CHECK(found_with("[a](dot.hpp) [b](dot.hpp#L2) [c](dot.hpp#L2-L3)") == Findings{});
  CHECK(found_with("[a](../../exercises/ch01_dots) [b](tests/)") == Findings{});
  CHECK(found_with("[a](#a-heading) [b](#a-heading-1)") == Findings{});
  CHECK(found_with("[a](https://example.org/none) [b](mailto:a@example.org)") == Findings{});
}

TEST_CASE("links: a link to a file that is not there is found") {
  CHECK(found_with("[a](../ch03_planes/README.md)") ==
        Findings{{page, 1,
                  "link \"../ch03_planes/README.md\": there is no "
                  "chapters/ch03_planes/README.md"}});
  CHECK(found_with("[a](../../../outside.md)").size() == 1);
  CHECK(found_with("[a](/chapters/ch01_dots/README.md)").size() == 1);
  CHECK(found_with("<img src=\"figures/none.png\" alt=\"none\">").size() == 1);
}

TEST_CASE("links: an anchor that no heading has is found") {
  CHECK(found_with("[a](#a-heading-2)") ==
        Findings{{page, 1, "link \"#a-heading-2\": " + page + " has no heading #a-heading-2"}});
  CHECK(found_with("[a](../ch01_dots/README.md#the-solution)").size() == 1);
  CHECK(found_with("[a](dot.hpp#L999)").size() == 1);
  CHECK(found_with("[a](dot.hpp#dot)").size() == 1);
}

TEST_CASE("links: a picture without words is found") {
  CHECK(found_with("![](figures/first.png)") ==
        Findings{{page, 1, "picture without a text that says what to see"}});
  CHECK(found_with("<img src=\"figures/first.png\">").size() == 1);
  CHECK(found_with("![words](figures/first.png)").empty());
}
