// `./learn` as a person meets it who mistypes. What its commands do is tested in runner/tests.
#include <algorithm>

#include "common/testkit/catch.hpp"
#include "tests/house/process.hpp"
#include "tests/house/programs.hpp"

using namespace lt::house;

namespace {

using Words = std::vector<std::string>;

// Runs the runner with a learner's folder of its own, so that nobody's work is touched.
Outcome learn(const Words& words, const TemporaryFolder& my) {
  Words command = {"cmake", "-E", "env", "LT_MY=" + my.path().string(), learn_program().string()};
  command.insert(command.end(), words.begin(), words.end());
  return run(command, my.path());
}

std::string shown(const Words& words) {
  std::string line = "./learn";
  for (const std::string& word : words)
    line += " " + (word.empty() ? "\"\"" : word);
  return line;
}

}  // namespace

TEST_CASE("learn: help names every command and ends well") {
  for (const Words& words : {Words{"help"}, Words{"--help"}}) {
    const TemporaryFolder my;
    const Outcome outcome = learn(words, my);
    INFO(shown(words));
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    for (const std::string name :
         {"render", "chapter", "test", "bench", "site", "doctor", "figures", "next", "list", "run",
          "hint", "solution", "reset", "verify"}) {
      INFO(name);
      CHECK(outcome.out.find("\n  ./learn " + name + " ") != std::string::npos);  // one line each
    }
    CHECK(outcome.out.find("study") == std::string::npos);  // comes with chapter 14
  }
}

TEST_CASE("learn: bad input ends with one line - exit code 2 - and no file") {
  const std::vector<Words> mistakes = {
      {"no-such-command"},
      {"--no-such-option"},
      {"help", "no-such-command"},
      {"render", "--fast"},
      {"render", "3"},
      {"chapter"},
      {"chapter", "99"},
      {"chapter", "ray casting"},
      {"chapter", ""},
      {"chapter", "99999999999999999999"},
      {"test", "--quick"},
      {"bench", "--fast"},
      {"bench", "rays"},
      {"figures", "99"},
      {"figures", "1", "2"},
      {"snippets", "--chekc"},
      {"site", "--port"},
      {"site", "--port", "abc"},
      {"site", "--port", "70000"},
      {"doctor", "me"},
      {"next", "02.2"},
      {"list", "all"},
      {"run", "99.9"},
      {"run", "no-such-exercise"},
      {"run", "--merge", "01.1", "01.2"},
      {"hint", "99.9"},
      {"solution", "99.9"},
      {"solution", "--any"},
      {"reset", "99.9"},
      {"verify", "--everything"},
      {"verify", "--seeds", "0"},
      {"verify", "--seeds", "-1"},
      {"verify", "--seeds", "many"},
      {"measure-edits", "--count", "0"},
      {"judge", "one", "two"},
  };
  for (const Words& words : mistakes) {
    const TemporaryFolder my;
    const Outcome outcome = learn(words, my);
    INFO(shown(words) << "\nstdout: " << outcome.out << "\nstderr: " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK(std::filesystem::is_empty(my.path()));
  }
}
