#include "tests/house/links.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <regex>

#include "tests/house/markdown.hpp"

namespace lt::house {
namespace {

// Pages by name, each read once however many links lead to it.
class Pages {
 public:
  explicit Pages(const Tree& tree) : tree_(tree) {}

  const Page& operator[](const std::string& name) {
    const auto found = pages_.find(name);
    if (found != pages_.end()) return found->second;
    return pages_[name] = parse_markdown(tree_.lines(name));
  }

 private:
  const Tree& tree_;
  std::map<std::string, Page> pages_;
};

bool leads_elsewhere(const std::string& target) {
  static const std::regex scheme("^[a-z][a-z0-9+.-]*:.*");
  return std::regex_match(target, scheme);
}

// The name from the root of what `link` means on the page `file`.
std::string resolved(const std::string& file, const std::string& link) {
  if (link.empty()) return file;
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::string name = (folder / link).lexically_normal().generic_string();
  if (name.ends_with('/')) name.pop_back();
  return name;
}

std::optional<std::string> wrong_anchor(const Tree& tree, Pages& pages, const std::string& name,
                                        const std::string& anchor) {
  if (name.ends_with(".md")) {
    if (pages[name].has_anchor(anchor)) return std::nullopt;
    return name + " has no heading #" + anchor;
  }
  static const std::regex line_form("L([0-9]+)(-L([0-9]+))?");
  std::smatch match;
  if (!std::regex_match(anchor, match, line_form)) return "#" + anchor + " leads nowhere";
  const std::string last = match[3].matched ? match[3].str() : match[1].str();
  if (std::stoul(last) <= tree.lines(name).size()) return std::nullopt;
  return name + " has no line " + last;
}

std::optional<std::string> wrong_target(const Tree& tree, Pages& pages, const std::string& file,
                                        const std::string& target) {
  if (target.starts_with('/')) return "starts with a slash; write it relative to this page";
  const std::size_t hash = target.find('#');
  const std::string name = resolved(file, target.substr(0, hash));
  if (name == "." || tree.has_folder(name)) return std::nullopt;
  if (!tree.has_file(name)) return "there is no " + name;
  if (hash == std::string::npos) return std::nullopt;
  return wrong_anchor(tree, pages, name, target.substr(hash + 1));
}

}  // namespace

Findings check_links(const Tree& tree) {
  Findings findings;
  Pages pages(tree);
  for (const std::string& file : tree.files_in("", ".md")) {
    for (const Link& link : pages[file].links) {
      if (link.is_picture && link.text.empty()) {
        findings.push_back({file, link.line, "picture without a text that says what to see"});
      }
      if (leads_elsewhere(link.target)) continue;
      const std::optional<std::string> wrong = wrong_target(tree, pages, file, link.target);
      if (wrong) findings.push_back({file, link.line, "link \"" + link.target + "\": " + *wrong});
    }
  }
  return findings;
}

}  // namespace lt::house
