#include "tests/house/planted.hpp"

#include "common/files.hpp"
#include "common/testkit/catch.hpp"

namespace lt::house {
namespace {

std::string chapter_text(const std::string& chapter, int number, const std::string& exercise) {
  const std::string n = std::to_string(number);
  std::string text = "# " + n + ". A chapter\n\n![What to see](figures/first.png)\n\n";
  text += "*The first picture.* `./learn chapter " + n + " --view first`\n\n";
  text +=
      "- **Builds on** what was.\n- **You will add** what is.\n- **You will be able to** go "
      "on.\n\n";
  text += "## The problem\n\n";
  for (int i = 0; i < 300; ++i)
    text += "Five words make a line.\n";
  text += "\n## The idea\n\n![A drawing](figures/drawing.svg)\n\n## The maths\n\n$$\na + b\n$$\n\n";
  text += "## The code\n\n<!-- snippet: dot.hpp dot -->\n```cpp\nint dot();\n```\n\n";
  text += "## Look\n\n## Does it hold?\n\n## What it costs\n\n## Exercises\n\n";
  text += "- [The exercise](../../exercises/" + chapter + "/" + exercise + "/README.md)\n\n";
  return text +
         "## What you have now\n\n## Read on\n\n## Next\n\nBack to [the top](#the-problem).\n";
}

void plant_chapter(PlantedProject& project, const std::string& chapter, int number,
                   const std::string& uses, const std::string& exercise) {
  const std::string folder = "chapters/" + chapter + "/";
  project.write(folder + "CMakeLists.txt", "lt_chapter(" + chapter + uses + ")\n");
  project.write(folder + "README.md", chapter_text(chapter, number, exercise));
  project.write(folder + "dot.hpp", "#pragma once\n\n// [dot]\nint dot();\n// [dot]\n");
  project.write(folder + "main.cpp",
                "#include <vector>\n\n#include \"" + chapter + "/dot.hpp\"\n\nint main() {}\n");
  project.write(folder + "tests/dot_test.cpp", "#include \"common/testkit/catch.hpp\"\n");
  project.write(folder + "figures/first.png", "stands for a picture");
  project.write(folder + "figures/drawing.svg", "<svg/>\n");
  project.write(
      folder + "pictures.json",
      "[{\"file\": \"first.png\", \"caption\": \"The first.\",\n"
      "  \"args\": [\"--view\", \"first\"], \"stored\": {\"width\": 8, \"height\": 4}}]\n");
}

void plant_exercise(PlantedProject& project, const std::string& chapter, const std::string& id,
                    const std::string& name) {
  const std::string folder = "exercises/" + chapter + "/" + name + "/";
  const std::string api = "#include \"api.hpp\"\n\n";
  project.write(folder + "exercise.json",
                "{\"id\": \"" + id + "\", \"name\": \"" + name + "\", \"title\": \"A task\",\n" +
                    " \"chapter\": \"" + chapter + "\", \"minutes\": 5,\n" +
                    " \"hints\": [\"What?\", \"Where?\", \"How?\"],\n \"mutants\": [\n" +
                    "  {\"tag\": \"off-by-one\", \"find\": \"+ 1\", \"replace\": \"+ 2\", "
                    "\"says\": \"One too many.\"},\n" +
                    "  {\"tag\": \"sign\", \"find\": \"return a\", \"replace\": \"return -a\", "
                    "\"says\": \"It points the other way.\"}]}\n");
  project.write(folder + "api.hpp",
                "#pragma once\n\n#include \"common/testkit/not_written.hpp\"\n");
  project.write(folder + "starter.cpp", api + "int f(int) { TODO(\"add one\"); }\n");
  project.write(folder + "solution.cpp", api + "int f(int a) { return a + 1; }\n");
  project.write(folder + "other.cpp", api + "int f(int a) { return 1 + a; }\n");
  project.write(folder + "test.cpp",
                api + "#include \"common/testkit/exercise.hpp\"\n\n" +
                    "// diagnose(..., \"off-by-one\", ...); diagnose(..., \"sign\", ...);\n");
  project.write(folder + "README.md", "# A task\n\nAdd one.\n");
}

}  // namespace

void PlantedProject::write(const std::string& name, const std::string& text) {
  write_file_whole(folder_.path() / name, text);
}

void PlantedProject::replace(const std::string& name, const std::string& find,
                             const std::string& by) {
  std::string text = read_file(folder_.path() / name);
  const std::size_t at = text.find(find);
  INFO("\"" << find << "\" in " << name);
  REQUIRE(at != std::string::npos);
  write(name, text.replace(at, find.size(), by));
}

void PlantedProject::remove(const std::string& name) {
  REQUIRE(std::filesystem::remove(folder_.path() / name));
}

void plant_complete_project(PlantedProject& project) {
  project.write("README.md",
                "# Dots\n\n[One](chapters/ch01_dots/README.md), "
                "[two](chapters/ch02_lines/README.md)\n");
  project.write("chapters/README.md",
                "# Contents\n\n[One](ch01_dots/README.md), [two](ch02_lines/README.md)\n\n"
                "![One leads to two](figures/chain.svg)\n");
  project.write("chapters/figures/chain.svg",
                "<svg><path id=\"ch01_dots-to-ch02_lines\"/></svg>\n");
  project.write("common/files.hpp", "// Plumbing.\n#pragma once\n\n#include <string>\n");
  plant_chapter(project, "ch01_dots", 1, "", "count");
  plant_chapter(project, "ch02_lines", 2, " USES ch01_dots", "measure");
  plant_exercise(project, "ch01_dots", "01.1", "count");
  plant_exercise(project, "ch02_lines", "02.1", "measure");
}

}  // namespace lt::house
