#include "tests/house/snippets.hpp"

#include "runner/snippets.hpp"
#include "tests/house/chapters.hpp"
#include "tests/house/markdown.hpp"

namespace lt::house {
namespace {

constexpr std::size_t most_lines = 30;

void check_fences(const Tree& tree, const std::string& file, Findings& findings) {
  for (const Fence& fence : parse_markdown(tree.lines(file)).fences) {
    if (fence.language != "cpp") continue;
    if (fence.before == "<!-- not compiled: -->") {
      findings.push_back({file, fence.line, "not compiled, and does not say why"});
    }
    if (fence.body.size() > most_lines) {
      findings.push_back(
          {file, fence.line, std::to_string(fence.body.size()) + " lines of code; at most 30"});
    }
  }
}

void check_equality(const Tree& tree, const std::string& chapter, Findings& findings) {
  Home home;
  home.root = tree.root();
  const FreshText fresh = chapter_with_fresh_snippets(home, chapter);
  const std::string file = "chapters/" + chapter + "/README.md";
  for (const SnippetProblem& problem : fresh.broken) {
    findings.push_back({file, problem.line, problem.what});
  }
  for (const SnippetProblem& problem : fresh.drifted) {
    findings.push_back({file, problem.line, problem.what + " (./learn snippets mends it)"});
  }
}

}  // namespace

Findings check_snippets(const Tree& tree) {
  Findings findings;
  for (const std::string& chapter : chapters_of(tree)) {
    const std::string file = "chapters/" + chapter + "/README.md";
    if (!tree.has_file(file)) continue;  // check_chapters says so
    check_fences(tree, file, findings);
    check_equality(tree, chapter, findings);
  }
  return findings;
}

}  // namespace lt::house
