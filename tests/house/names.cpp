#include "tests/house/names.hpp"

#include <filesystem>
#include <regex>

#include "runner/text.hpp"

namespace lt::house {
namespace {

// What is taught is read in one sitting; plumbing may be somewhat longer, and a list of tests more.
std::size_t most_lines(const std::string& file) {
  if (file.find("tests/") != std::string::npos) return 300;
  return file.starts_with("chapters/") ? 200 : 250;
}

// Tables that are laid out by hand, "clang-format off", are not read line by line: they do not
// count.
std::size_t counted_lines(const std::vector<std::string>& lines) {
  std::size_t count = 0;
  bool is_table = false;
  for (const std::string& line : lines) {
    if (line.ends_with("// clang-format off")) is_table = true;
    if (line.ends_with("// clang-format on")) is_table = false;
    count += is_table ? 0 : 1;
  }
  return count;
}

// Where a rule applies, and the form that it asks for.
struct Rule {
  std::regex where;
  std::regex form;
  std::string says;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> list = {
      {std::regex("chapters/[^/]+/.*"), std::regex("chapters/(ch[0-9]{2}_[a-z0-9_]+|figures)/.*"),
       "chapters are named ch01_lower_case"},
      {std::regex(R"(.*\.(h|hh|hxx|cc|cxx|c\+\+))"), std::regex("never"),
       "C++ files end in .hpp or .cpp"},
      {std::regex(R"((.*/)?[^/]+\.[hc]pp)"), std::regex(R"((.*/)?[a-z][a-z0-9_]*\.[hc]pp)"),
       "C++ files are snake_case"},
      {std::regex(R"(((chapters/[^/]+|common|runner)/)?tests/[^/]+\.cpp)"),
       std::regex(R"(.*_test\.cpp)"), "tests end in _test.cpp"},
      {std::regex(R"((.*/)?figures/[^/]+)"),
       std::regex(R"((.*/)?[a-z0-9]+(-[a-z0-9]+)*\.(png|svg))"),
       "figures are lower-case-with-hyphens.png or .svg"},
      {std::regex("exercises/[^/]+/[^/]+/.*"),
       std::regex("exercises/ch[0-9]{2}_[a-z0-9_]+/[a-z0-9]+(-[a-z0-9]+)*/.*"),
       "exercises are named CHAPTER/lower-case-with-hyphens"},
  };
  return list;
}

void check_name(const std::string& file, Findings& findings) {
  for (const Rule& rule : rules()) {
    if (std::regex_match(file, rule.where) && !std::regex_match(file, rule.form)) {
      findings.push_back({file, 0, rule.says});
    }
  }
}

void check_lines(const std::string& file, const std::vector<std::string>& lines,
                 Findings& findings) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const int number = static_cast<int>(i) + 1;
    if (line.find('\t') != std::string::npos) findings.push_back({file, number, "has a tab"});
    const bool may_break = file.ends_with(".md");  // two blanks end a line there
    if (line.ends_with(' ') && !may_break) findings.push_back({file, number, "ends with a blank"});
  }
}

void check_cpp(const std::string& file, const std::vector<std::string>& lines, Findings& findings) {
  const std::size_t count = counted_lines(lines);
  if (count > most_lines(file)) {
    findings.push_back({file, 0,
                        std::to_string(count) + " lines; at most " +
                            std::to_string(most_lines(file)) + " are read gladly"});
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool names_test =
        lines[i].starts_with("TEST_CASE(\"") || (i > 0 && lines[i - 1] == "TEST_CASE(");
    if (names_test && lines[i].find(';') != std::string::npos)
      findings.push_back({file, static_cast<int>(i) + 1,
                          "has a semicolon in a test's name: CTest takes it for two tests"});
  }
  if (!file.ends_with(".hpp")) return;
  for (const std::string& line : lines) {
    if (line == "#pragma once") return;
    if (!line.empty() && !line.starts_with("//")) break;
  }
  findings.push_back({file, 0, "has no #pragma once below its first comment"});
}

}  // namespace

Findings check_names(const Tree& tree) {
  Findings findings;
  for (const std::string& file : tree.files()) {
    check_name(file, findings);
    if (!is_text(file) || file.ends_with("package-lock.json")) continue;
    const std::string text = tree.text(file);
    if (text.find('\r') != std::string::npos) findings.push_back({file, 0, "has carriage returns"});
    if (!text.empty() && !text.ends_with('\n')) {
      findings.push_back({file, 0, "does not end with a newline"});
    }
    const std::vector<std::string> lines = split_lines(text);
    check_lines(file, lines, findings);
    if (is_cpp(file)) check_cpp(file, lines, findings);
  }
  return findings;
}

}  // namespace lt::house
