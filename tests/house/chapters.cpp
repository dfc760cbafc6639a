#include "tests/house/chapters.hpp"

#include <algorithm>
#include <array>

#include "tests/house/descriptions.hpp"
#include "tests/house/markdown.hpp"

namespace lt::house {
namespace {

constexpr std::array parts = {
    "The problem",   "The idea",  "The maths",         "The code", "Look", "Does it hold?",
    "What it costs", "Exercises", "What you have now", "Read on",  "Next"};

constexpr int fewest_words = 1500;
constexpr int most_words = 3000;
constexpr std::size_t most_main_lines = 80;

void check_title(const Page& page, const std::string& file, int number, Findings& findings) {
  const std::string start = std::to_string(number) + ". ";
  const auto titles = std::ranges::count(page.headings, 1, &Heading::level);
  if (titles == 1 && page.headings[0].level == 1 && page.headings[0].text.starts_with(start))
    return;
  findings.push_back({file, 1, "starts with its one title, \"# " + start + "...\""});
}

void check_parts(const Page& page, const std::string& file, Findings& findings) {
  std::vector<Heading> found;
  std::ranges::copy_if(page.headings, std::back_inserter(found),
                       [](const Heading& heading) { return heading.level == 2; });
  for (std::size_t i = 0; i < std::max(found.size(), parts.size()); ++i) {
    const std::string expected = i < parts.size() ? parts[i] : "nothing more";
    if (i < found.size() && found[i].text == expected) continue;
    const std::string there = i < found.size() ? "\"" + found[i].text + "\"" : "the end";
    findings.push_back({file, i < found.size() ? found[i].line : 0,
                        "expected the part \"" + expected + "\", found " + there});
    return;  // the rest would only repeat it
  }
}

// Between the title and the first part: the picture and the three lines.
void check_opening(const Page& page, const std::vector<std::string>& lines, const std::string& file,
                   Findings& findings) {
  const auto first_part = std::ranges::find(page.headings, 2, &Heading::level);
  const int end =
      first_part == page.headings.end() ? static_cast<int>(lines.size()) : first_part->line;
  const bool has_picture = std::ranges::any_of(
      page.links, [&](const Link& link) { return link.is_picture && link.line < end; });
  if (!has_picture) findings.push_back({file, 1, "opens without the picture it ends with"});
  for (const std::string phrase : {"Builds on", "You will add", "You will be able to"}) {
    const bool is_there = std::any_of(lines.begin(), lines.begin() + end, [&](const auto& line) {
      return line.find(phrase) != std::string::npos;
    });
    if (!is_there) findings.push_back({file, 1, "the opening lacks \"" + phrase + "\""});
  }
}

void check_text(const Tree& tree, const std::string& chapter, Findings& findings) {
  const std::string file = "chapters/" + chapter + "/README.md";
  if (!tree.has_file(file)) {
    findings.push_back({file, 0, "is missing"});
    return;
  }
  const std::vector<std::string> lines = tree.lines(file);
  const Page page = parse_markdown(lines);
  check_title(page, file, chapter_number(chapter), findings);
  check_opening(page, lines, file, findings);
  check_parts(page, file, findings);
  if (page.words < fewest_words || page.words > most_words) {
    findings.push_back({file, 0,
                        std::to_string(page.words) + " words; a chapter has " +
                            std::to_string(fewest_words) + " to " + std::to_string(most_words)});
  }
}

void check_code(const Tree& tree, const std::string& chapter, Findings& findings) {
  const std::string folder = "chapters/" + chapter + "/";
  if (!tree.has_file(folder + "main.cpp")) {
    findings.push_back({folder + "main.cpp", 0, "is missing"});
  } else if (tree.lines(folder + "main.cpp").size() > most_main_lines) {
    findings.push_back({folder + "main.cpp", 0, "is longer than 80 lines; it is wiring only"});
  }
  if (tree.files_in(folder + "tests/", ".cpp").empty()) {
    findings.push_back({folder + "tests", 0, "has no test"});
  }
  if (tree.files_in("exercises/" + chapter + "/", "/exercise.json").empty()) {
    findings.push_back({"exercises/" + chapter, 0, "has no exercise"});
  }
}

void check_pictures(const Tree& tree, const std::string& chapter, Findings& findings) {
  const std::string folder = "chapters/" + chapter + "/";
  if (!tree.has_file(folder + "pictures.json")) {
    findings.push_back({folder + "pictures.json", 0, "is missing"});
    return;
  }
  const std::size_t before = findings.size();
  const std::vector<Picture> pictures = read_pictures(tree, chapter, findings);
  const bool is_refused = findings.size() > before;
  if (!is_refused && std::ranges::none_of(pictures, &Picture::is_stored)) {
    findings.push_back({folder + "pictures.json", 0, "stores no picture for the text"});
  }
}

void check_listed(const Tree& tree, const std::string& chapter, Findings& findings) {
  for (const std::string file : {"README.md", "chapters/README.md"}) {
    if (tree.has_file(file) && tree.text(file).find(chapter + "/README.md") != std::string::npos) {
      continue;
    }
    findings.push_back({file, 0, "does not link to " + chapter + "/README.md"});
  }
}

}  // namespace

std::vector<std::string> chapters_of(const Tree& tree) {
  std::vector<std::string> chapters = tree.folders_in("chapters/");
  std::erase_if(chapters, [](const std::string& name) { return chapter_number(name) == 0; });
  return chapters;
}

Findings check_chapters(const Tree& tree) {
  Findings findings;
  for (const std::string& chapter : chapters_of(tree)) {
    check_text(tree, chapter, findings);
    check_code(tree, chapter, findings);
    check_pictures(tree, chapter, findings);
    check_listed(tree, chapter, findings);
  }
  return findings;
}

}  // namespace lt::house
