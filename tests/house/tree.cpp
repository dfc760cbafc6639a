#include "tests/house/tree.hpp"

#include <algorithm>
#include <array>

#include "common/files.hpp"
#include "runner/text.hpp"
#include "tests/house/process.hpp"

namespace lt::house {
namespace {

namespace fs = std::filesystem;

// What git tracks or would track; nothing where git is missing or refuses.
std::vector<std::string> names_from_git(const fs::path& root) {
  const Outcome git = run(
      {"git", "-C", root.string(), "ls-files", "-z", "--cached", "--others", "--exclude-standard"});
  std::vector<std::string> names;
  if (git.exit_code != 0) return names;
  for (std::size_t start = 0; start < git.out.size();) {
    const std::size_t end = git.out.find('\0', start);
    names.push_back(git.out.substr(start, end - start));
    start = end + 1;
  }
  return names;
}

std::vector<std::string> names_from_walk(const fs::path& root) {
  static constexpr std::array left_out = {".git", "build", "out", "my", "node_modules", ".cache"};
  std::vector<std::string> names;
  for (auto it = fs::recursive_directory_iterator(root); it != fs::end(it); ++it) {
    if (it->is_directory() && std::ranges::count(left_out, it->path().filename().string()) > 0) {
      it.disable_recursion_pending();
    } else if (it->is_regular_file()) {
      names.push_back(it->path().lexically_relative(root).generic_string());
    }
  }
  return names;
}

}  // namespace

Tree::Tree(fs::path root) : root_(std::move(root)) {
  if (fs::exists(root_ / ".git")) files_ = names_from_git(root_);
  if (files_.empty()) files_ = names_from_walk(root_);
  std::ranges::sort(files_);
  files_.erase(std::unique(files_.begin(), files_.end()), files_.end());
  // A file that was deleted but not yet committed is still in git's list.
  std::erase_if(files_,
                [&](const std::string& name) { return !fs::is_regular_file(root_ / name); });
  names_ = {files_.begin(), files_.end()};
}

std::vector<std::string> Tree::files_in(std::string_view folder, std::string_view ending) const {
  std::vector<std::string> found;
  for (const std::string& name : files_) {
    if (name.starts_with(folder) && name.ends_with(ending)) found.push_back(name);
  }
  return found;
}

std::vector<std::string> Tree::folders_in(std::string_view folder) const {
  std::set<std::string> found;
  for (const std::string& name : files_in(folder)) {
    const std::size_t slash = name.find('/', folder.size());
    if (slash != std::string::npos) found.insert(name.substr(folder.size(), slash - folder.size()));
  }
  return {found.begin(), found.end()};
}

bool Tree::has_folder(const std::string& name) const {
  const std::string prefix = name.ends_with('/') || name.empty() ? name : name + "/";
  const auto first = names_.lower_bound(prefix);
  return first != names_.end() && first->starts_with(prefix);
}

std::string Tree::text(const std::string& name) const {
  return read_file(root_ / name);
}

std::vector<std::string> Tree::lines(const std::string& name) const {
  return split_lines(text(name));
}

bool is_text(std::string_view name) {
  static constexpr std::array pictures = {".png", ".jpg", ".jpeg", ".pfm", ".ico", ".woff2"};
  return std::ranges::none_of(pictures, [&](const char* end) { return name.ends_with(end); });
}

bool is_cpp(std::string_view name) {
  return name.ends_with(".hpp") || name.ends_with(".cpp");
}

std::string second_part(std::string_view name) {
  const std::size_t first = name.find('/');
  if (first == std::string_view::npos) return "";
  const std::size_t second = name.find('/', first + 1);
  return std::string(name.substr(first + 1, second - first - 1));
}

int chapter_number(const std::string& chapter) {
  const auto digit = [&](std::size_t i) {
    return i < chapter.size() && chapter[i] >= '0' && chapter[i] <= '9' ? chapter[i] - '0' : 0;
  };
  return chapter.starts_with("ch") ? 10 * digit(2) + digit(3) : 0;
}

}  // namespace lt::house
