#include "tests/house/words.hpp"

#include "common/testkit/catch.hpp"
#include "tests/house/planted.hpp"

using namespace lt::house;

namespace {

// How many findings a page with this text has.
std::size_t findings_in(const std::string& text) {
  PlantedProject project;
  project.write("README.md", "A page.\n" + text + "\n");
  return check_words(project.tree()).size();
}

}  // namespace

// The words are put together here for the reason that words.cpp gives.
TEST_CASE("words: a folder of the machine is found with its line") {
  PlantedProject project;
  project.write("README.md", "A page.\nSee /ho" + std::string("me/kim/x.\n"));
  CHECK(check_words(project.tree()) ==
        Findings{{"README.md", 2, "\"/ho" + std::string("me/\" is a folder of one machine")}});
}

TEST_CASE("words: a registry's host and a word of the workshop are found in any case") {
  CHECK(findings_in("https://Registry.NP" + std::string("Mjs.org/x")) == 1);
  CHECK(findings_in("An AG" + std::string("ENT wrote it.")) == 1);
}

TEST_CASE("words: parts of longer words and of relative names are left alone") {
  CHECK(findings_in("ag" + std::string("enda, reag") + "ents") == 0);
  CHECK(findings_in("out/ho" + std::string("me/page")) == 0);
}
