#include "tests/house/tree.hpp"

#include "common/testkit/catch.hpp"
#include "tests/house/planted.hpp"

using namespace lt::house;

TEST_CASE("tree: where there is no git what is made is left out") {
  PlantedProject project;
  for (const std::string name :
       {"a.md", "common/b.hpp", "build/c.hpp", "out/d.png", "my/e.cpp", "docs/node_modules/f.js"}) {
    project.write(name, "\n");
  }
  CHECK(project.tree().files() == std::vector<std::string>{"a.md", "common/b.hpp"});
}

TEST_CASE("tree: where there is git what it ignores is left out") {
  PlantedProject project;
  project.write("kept.md", "\n");
  project.write("two words.md", "\n");
  project.write("ignored.md", "\n");
  project.write(".gitignore", "/ignored.md\n");
  if (run({"git", "init", "-q", project.tree().root().string()}).exit_code != 0) return;
  CHECK(project.tree().files() ==
        std::vector<std::string>{".gitignore", "kept.md", "two words.md"});
}

TEST_CASE("tree: folders and files are found by their names") {
  PlantedProject project;
  project.write("chapters/ch01_dots/dot.hpp", "one\ntwo\n\nfour");
  const Tree tree = project.tree();
  CHECK(tree.has_file("chapters/ch01_dots/dot.hpp"));
  CHECK(tree.has_folder("chapters/ch01_dots"));
  CHECK(tree.has_folder("chapters/"));
  CHECK_FALSE(tree.has_folder("chapters/ch01"));
  CHECK_FALSE(tree.has_file("chapters/ch01_dots"));
  CHECK(tree.folders_in("chapters/") == std::vector<std::string>{"ch01_dots"});
  CHECK(tree.lines("chapters/ch01_dots/dot.hpp") ==
        std::vector<std::string>{"one", "two", "", "four"});
  CHECK(second_part("chapters/ch01_dots/dot.hpp") == "ch01_dots");
  CHECK(chapter_number("ch12_russian_roulette") == 12);
  CHECK(chapter_number("figures") == 0);
}

TEST_CASE("process: exit code and both streams come back, arguments arrive unharmed") {
  const Outcome told = run({"cmake", "-E", "echo", "it's \"one\" $HOME *"});
  CHECK(told.exit_code == 0);
  CHECK(told.out == "it's \"one\" $HOME *\n");
  const Outcome refused = run({"cmake", "-E", "cat", "no-such-file"});
  CHECK(refused.exit_code != 0);
  CHECK(refused.out.empty());
  CHECK_FALSE(refused.err.empty());
}
