#include "tests/house/figures.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "tests/house/chapters.hpp"
#include "tests/house/descriptions.hpp"
#include "tests/house/includes.hpp"
#include "tests/house/markdown.hpp"

namespace lt::house {
namespace {

constexpr std::uintmax_t most_bytes = 200 * 1024;
constexpr std::size_t caption_lines = 12;  // how far below its picture a command may stand

// All pictures that some page shows, by their names from the root.
std::set<std::string> shown_pictures(const Tree& tree) {
  std::set<std::string> shown;
  for (const std::string& file : tree.files_in("", ".md")) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    for (const Link& link : parse_markdown(tree.lines(file)).links) {
      if (link.is_picture) shown.insert((folder / link.target).lexically_normal().generic_string());
    }
  }
  return shown;
}

// "./learn chapter 2 --view normals"
std::string command_of(const std::string& chapter, const Picture& picture) {
  std::string command = "./learn chapter " + std::to_string(chapter_number(chapter));
  for (const std::string& arg : picture.args)
    command += " " + arg;
  return command;
}

void check_stored(const Tree& tree, const std::string& folder, const std::vector<Picture>& pictures,
                  Findings& findings) {
  for (const Picture& picture : pictures) {
    if (!picture.is_stored || tree.has_file(folder + picture.file)) continue;
    findings.push_back({folder + picture.file, 0, "is listed as stored but is not there"});
  }
}

void check_files(const Tree& tree, const std::string& folder, const std::vector<Picture>& pictures,
                 const std::set<std::string>& shown, Findings& findings) {
  for (const std::string& name : tree.files_in(folder)) {
    const std::string file = name.substr(folder.size());
    const auto made = std::ranges::find(pictures, file, &Picture::file);
    if (made == pictures.end() ? !name.ends_with(".svg") : !made->is_stored) {
      findings.push_back({name, 0, "has no entry with \"stored\" in pictures.json"});
    }
    if (!shown.contains(name)) findings.push_back({name, 0, "is shown by no page"});
    if (std::filesystem::file_size(tree.root() / name) > most_bytes) {
      findings.push_back({name, 0, "is larger than 200 KB"});
    }
  }
}

// chapters/figures/chain.svg has a path for every arrow of the code's, named FROM-to-TO.
void check_chain(const Tree& tree, Findings& findings) {
  const std::string file = "chapters/figures/chain.svg";
  const std::string drawing = tree.has_file(file) ? tree.text(file) : "";
  for (const auto& [chapter, used] : read_direct_uses(tree)) {
    for (const std::string& earlier : used) {
      if (drawing.find("id=\"" + earlier + "-to-" + chapter + '"') != drawing.npos) continue;
      findings.push_back({file, 0, "has no arrow " + earlier + "-to-" + chapter});
    }
  }
}

// The command belongs below its picture; of several in a row or a table, below them all.
void check_captions(const Tree& tree, const std::string& chapter,
                    const std::vector<Picture>& pictures, Findings& findings) {
  const std::string file = "chapters/" + chapter + "/README.md";
  if (!tree.has_file(file)) return;
  const std::vector<std::string> lines = tree.lines(file);
  for (const Link& link : parse_markdown(lines).links) {
    const auto made = std::ranges::find_if(pictures, [&](const Picture& picture) {
      return link.is_picture && link.target == "figures/" + picture.file;
    });
    if (made == pictures.end()) continue;
    const std::string command = command_of(chapter, *made);
    const std::size_t from = static_cast<std::size_t>(link.line) - 1;
    const std::size_t to = std::min(from + caption_lines, lines.size());
    const bool is_there = std::any_of(
        lines.begin() + static_cast<long>(from), lines.begin() + static_cast<long>(to),
        [&](const std::string& line) { return line.find(command) != std::string::npos; });
    if (!is_there) findings.push_back({file, link.line, "no `" + command + "` below its picture"});
  }
}

}  // namespace

Findings check_figures(const Tree& tree) {
  Findings findings;
  const std::set<std::string> shown = shown_pictures(tree);
  check_chain(tree, findings);
  check_files(tree, "chapters/figures/", {}, shown, findings);
  for (const std::string& chapter : chapters_of(tree)) {
    if (!tree.has_file("chapters/" + chapter + "/pictures.json")) continue;
    Findings told_elsewhere;  // by check_chapters
    const std::vector<Picture> pictures = read_pictures(tree, chapter, told_elsewhere);
    const std::string folder = "chapters/" + chapter + "/figures/";
    check_stored(tree, folder, pictures, findings);
    check_files(tree, folder, pictures, shown, findings);
    check_captions(tree, chapter, pictures, findings);
  }
  return findings;
}

}  // namespace lt::house
