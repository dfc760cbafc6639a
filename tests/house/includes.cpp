#include "tests/house/includes.hpp"

#include <optional>
#include <regex>
#include <sstream>

namespace lt::house {
namespace {

struct Include {
  int line;
  std::string name;
  bool is_quoted;  // "name", not <name>
};

std::vector<Include> includes_of(const Tree& tree, const std::string& file) {
  static const std::regex form(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<Include> found;
  int number = 0;
  for (const std::string& line : tree.lines(file)) {
    ++number;
    std::smatch match;
    if (line.find('#') == std::string::npos || !std::regex_match(line, match, form)) continue;
    found.push_back({number, match[2], match[1] == "\""});
  }
  return found;
}

std::string first_part(const std::string& name) {
  return name.substr(0, name.find('/'));
}

// What is wrong with an include, whoever writes it.
std::optional<std::string> wrong_anywhere(const std::string& file, const Include& include) {
  if (include.name.starts_with("../") || include.name.find("/../") != std::string::npos) {
    return "relative include; write the name from the root, e.g. \"common/files.hpp\"";
  }
  if (include.name.starts_with("catch2/") && file != "common/testkit/catch.hpp") {
    return "includes Catch2 itself; include \"common/testkit/catch.hpp\"";
  }
  const std::string part = first_part(include.name);
  const bool is_ours = part == "common" || part == "runner" || chapter_number(part) > 0;
  if (!include.is_quoted && is_ours) return "is ours: include it in quotation marks";
  return std::nullopt;
}

std::optional<std::string> wrong_in_common(const std::string& file, const std::string& name) {
  if (first_part(name) != "common") return "common/ includes nothing of ours but common/";
  const bool is_kit = file.starts_with("common/testkit/") || file.starts_with("common/tests/");
  if (name.starts_with("common/testkit/") && !is_kit) return "only tests include the test kit";
  return std::nullopt;
}

std::optional<std::string> wrong_in_chapter(const std::string& file, const std::string& name,
                                            const Uses& uses) {
  const std::string chapter = second_part(file);
  const std::string part = first_part(name);
  if (part == "common") {
    const bool is_test = file.starts_with("chapters/" + chapter + "/tests/");
    // Programs measure their own noise and count their own samples.
    const bool is_measure =
        name == "common/testkit/statistics.hpp" || name == "common/testkit/sampler_test.hpp";
    const bool is_kit = name.starts_with("common/testkit/") && !is_measure;
    return is_kit && !is_test ? std::optional("only tests include the test kit") : std::nullopt;
  }
  if (chapter_number(part) == 0)
    return "write the name with its folder, e.g. \"" + chapter + "/...\"";
  const auto found = uses.find(chapter);
  if (found != uses.end() && found->second.contains(part)) return std::nullopt;
  if (chapter_number(part) > chapter_number(chapter)) {
    return "points forward: " + chapter + " must not know of " + part;
  }
  return part + " is not among the USES of " + chapter + " (chapters/" + chapter +
         "/CMakeLists.txt)";
}

std::optional<std::string> wrong_in_exercise(const std::string& file, const std::string& name) {
  if (name == "api.hpp" || name == "common/testkit/not_written.hpp") return std::nullopt;
  const bool is_kit = name == "common/testkit/exercise.hpp" ||
                      name == "common/testkit/hemisphere.hpp" ||
                      name == "common/testkit/statistics.hpp";
  const bool is_test = file.ends_with("/test.cpp");
  if (is_test && name == "formulas.hpp") return std::nullopt;
  if (is_kit && (is_test || file.ends_with("/formulas.hpp"))) return std::nullopt;
  return "an exercise includes its api.hpp and its test the kit and its formulas.hpp, nothing else "
         "of ours";
}

std::optional<std::string> wrong_here(const std::string& file, const std::string& name,
                                      const Uses& uses) {
  // The runner's tests have exercises of their own.
  const bool is_exercise = file.starts_with("exercises/") || file.find("/exercises/") != file.npos;
  if (is_exercise) return wrong_in_exercise(file, name);
  if (file.starts_with("common/")) return wrong_in_common(file, name);
  if (file.starts_with("chapters/")) return wrong_in_chapter(file, name, uses);
  const bool is_runner = file.starts_with("runner/");
  if (is_runner && first_part(name) != "runner" && first_part(name) != "common") {
    return "the runner includes no chapter and no test";
  }
  if (name.find('/') == std::string::npos) return "write the name with its folder";
  return std::nullopt;
}

// The words of "lt_chapter(NAME USES a b)", without "USES".
std::vector<std::string> declaration(const Tree& tree, const std::string& chapter) {
  static const std::regex form(R"(\blt_chapter\(([^)]*)\))");
  const std::string text = tree.text("chapters/" + chapter + "/CMakeLists.txt");
  std::smatch match;
  std::vector<std::string> words;
  if (!std::regex_search(text, match, form)) return words;
  std::istringstream list(match[1]);
  for (std::string word; list >> word;) {
    if (word != "USES") words.push_back(word);
  }
  return words;
}

std::vector<std::string> declared_chapters(const Tree& tree) {
  std::vector<std::string> chapters;
  for (const std::string& name : tree.folders_in("chapters/")) {
    if (tree.has_file("chapters/" + name + "/CMakeLists.txt")) chapters.push_back(name);
  }
  return chapters;
}

void check_declarations(const Tree& tree, Findings& findings) {
  for (const std::string& chapter : declared_chapters(tree)) {
    const std::string file = "chapters/" + chapter + "/CMakeLists.txt";
    const std::vector<std::string> words = declaration(tree, chapter);
    if (words.empty() || words[0] != chapter) {
      findings.push_back({file, 0, "one name everywhere: declare lt_chapter(" + chapter + " ...)"});
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (chapter_number(words[i]) < chapter_number(chapter)) continue;
      findings.push_back({file, 0, "points forward: " + chapter + " must not use " + words[i]});
    }
  }
}

}  // namespace

Uses read_direct_uses(const Tree& tree) {
  Uses uses;
  for (const std::string& chapter : declared_chapters(tree)) {
    const std::vector<std::string> words = declaration(tree, chapter);
    if (!words.empty()) uses[chapter] = {words.begin() + 1, words.end()};
  }
  return uses;
}

Uses read_uses(const Tree& tree) {
  Uses all;
  // Names sort by number, so what a chapter stands on is known before it.
  for (const auto& [chapter, direct] : read_direct_uses(tree)) {
    all[chapter].insert(chapter);
    for (const std::string& used : direct)
      all[chapter].insert(all[used].begin(), all[used].end());
  }
  return all;
}

Findings check_includes(const Tree& tree) {
  Findings findings;
  check_declarations(tree, findings);
  const Uses uses = read_uses(tree);
  for (const std::string& file : tree.files()) {
    if (!is_cpp(file)) continue;
    for (const Include& include : includes_of(tree, file)) {
      std::optional<std::string> wrong = wrong_anywhere(file, include);
      if (!wrong && include.is_quoted) wrong = wrong_here(file, include.name, uses);
      if (wrong) findings.push_back({file, include.line, '"' + include.name + "\": " + *wrong});
    }
  }
  return findings;
}

}  // namespace lt::house
