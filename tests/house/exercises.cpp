#include "tests/house/exercises.hpp"

#include <array>
#include <set>

#include "tests/house/descriptions.hpp"

namespace lt::house {
namespace {

constexpr std::array files = {"exercise.json", "api.hpp",   "starter.cpp", "test.cpp",
                              "solution.cpp",  "other.cpp", "README.md"};

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; !part.empty() && (at = text.find(part, at)) != std::string::npos; ++at) {
    ++count;
  }
  return count;
}

bool has_all_files(const Tree& tree, const std::string& folder, Findings& findings) {
  bool all = true;
  for (const std::string name : files) {
    if (tree.has_file(folder + name)) continue;
    findings.push_back({folder + name, 0, "is missing"});
    all = false;
  }
  return all;
}

void check_mutants(const Tree& tree, const Exercise& exercise, const std::string& folder,
                   Findings& findings) {
  const std::string file = folder + "exercise.json";
  const std::string solution = tree.text(folder + "solution.cpp");
  const std::string formulas = folder + "formulas.hpp";  // a long test keeps its oracles there
  const std::string test =
      tree.text(folder + "test.cpp") + (tree.has_file(formulas) ? tree.text(formulas) : "");
  for (const Mutant& mutant : exercise.mutants) {
    const std::string name = "mutant \"" + mutant.tag + "\": ";
    const std::size_t count = occurrences(solution, mutant.find);
    if (count != 1) {
      findings.push_back(
          {file, 0, name + "\"find\" occurs " + std::to_string(count) + " times in solution.cpp"});
    }
    if (test.find('"' + mutant.tag + '"') == std::string::npos) {
      findings.push_back({file, 0, name + "is never diagnosed in test.cpp"});
    }
  }
}

void check_sources(const Tree& tree, const std::string& folder, Findings& findings) {
  for (const std::string name : {"starter.cpp", "test.cpp", "solution.cpp", "other.cpp"}) {
    if (tree.text(folder + name).find("#include \"api.hpp\"") == std::string::npos) {
      findings.push_back({folder + name, 0, "does not include \"api.hpp\""});
    }
  }
  if (tree.text(folder + "starter.cpp").find("TODO(") == std::string::npos) {
    findings.push_back({folder + "starter.cpp", 0, "has no TODO(...)"});
  }
}

void check_linked(const Tree& tree, const Exercise& exercise, Findings& findings) {
  const std::string chapter = "chapters/" + exercise.chapter + "/README.md";
  const std::string page = "exercises/" + exercise.chapter + "/" + exercise.name + "/README.md";
  if (tree.has_file(chapter) && tree.text(chapter).find("../../" + page) != std::string::npos)
    return;
  findings.push_back({chapter, 0, "does not link to " + page});
}

}  // namespace

Findings check_exercises(const Tree& tree) {
  Findings findings;
  std::set<std::string> ids;
  for (const std::string& chapter : tree.folders_in("exercises/")) {
    for (const std::string& name : tree.folders_in("exercises/" + chapter + "/")) {
      const std::string folder = "exercises/" + chapter + "/" + name + "/";
      if (!has_all_files(tree, folder, findings)) continue;
      const auto exercise = read_exercise(tree, folder + "exercise.json", findings);
      if (!exercise) continue;
      check_mutants(tree, *exercise, folder, findings);
      check_sources(tree, folder, findings);
      check_linked(tree, *exercise, findings);
      if (!ids.insert(exercise->id).second) {
        findings.push_back({folder + "exercise.json", 0, "id " + exercise->id + " is used twice"});
      }
    }
  }
  return findings;
}

}  // namespace lt::house
