#include "runner/snippets.hpp"

#include <algorithm>

#include "common/error.hpp"
#include "common/files.hpp"
#include "runner/pattern.hpp"
#include "runner/text.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

std::size_t indent_of(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

// Without the spaces that all lines begin with, and without empty lines at both ends.
std::string dedented(std::vector<std::string> lines) {
  const auto is_blank = [](const std::string& line) { return trimmed(line).empty(); };
  while (!lines.empty() && is_blank(lines.front()))
    lines.erase(lines.begin());
  while (!lines.empty() && is_blank(lines.back()))
    lines.pop_back();
  std::size_t indent = std::string::npos;
  for (const std::string& line : lines) {
    if (!is_blank(line)) indent = std::min(indent, indent_of(line));
  }
  std::string text;
  for (const std::string& line : lines) {
    text += (is_blank(line) ? "" : line.substr(indent)) + "\n";
  }
  return text;
}

// The README line by line, with the fence that is being read.
class Refresher {
 public:
  using ReadSource = std::function<std::optional<std::string>(const std::string&)>;

  Refresher(std::string_view readme, const ReadSource& read_source)
      : lines_(split_lines(readme)), read_source_(read_source) {}

  FreshText run() {
    static const Pattern comment(R"(^<!-- snippet: (\S+) (\S+) -->$)");
    for (at_ = 0; at_ < lines_.size(); ++at_) {
      const std::string& line = lines_[at_];
      if (const auto found = comment.match(line)) {
        refresh((*found)[1], (*found)[2]);
      } else if (line.starts_with("<!-- snippet")) {
        put(line);
        complain("a snippet is written <!-- snippet: FILE TAG -->");
      } else if (line.starts_with("```")) {
        copy_fence();
      } else {
        put(line);
      }
    }
    return std::move(fresh_);
  }

 private:
  void put(const std::string& line) { fresh_.text += line + "\n"; }

  void complain(const std::string& what) {
    fresh_.broken.push_back({static_cast<int>(at_) + 1, what});
  }

  // Other fences stay. C++ that is shown must be compiled, or say why it is not.
  void copy_fence() {
    const bool is_explained = at_ > 0 && lines_[at_ - 1].starts_with("<!-- not compiled:");
    if (lines_[at_] == "```cpp" && !is_explained) {
      complain("a cpp fence needs <!-- snippet: FILE TAG --> or <!-- not compiled: why --> above");
    }
    put(lines_[at_]);
    while (++at_ < lines_.size()) {
      put(lines_[at_]);
      if (lines_[at_].starts_with("```")) return;
    }
    at_ = lines_.size() - 1;
    complain("this fence never ends");
  }

  void refresh(const std::string& file, const std::string& tag) {
    const std::size_t comment = at_;
    put(lines_[at_]);
    if (at_ + 1 >= lines_.size() || lines_[at_ + 1] != "```cpp") {
      return complain("a ```cpp fence must follow directly");
    }
    std::string shown;
    for (at_ += 2; at_ < lines_.size() && lines_[at_] != "```"; ++at_)
      shown += lines_[at_] + "\n";
    if (at_ >= lines_.size()) {
      at_ = comment;
      complain("this fence never ends");
      at_ = lines_.size();
    }
    const std::optional<std::string> wanted = find(comment, file, tag);
    if (wanted && *wanted != shown) {
      fresh_.drifted.push_back({static_cast<int>(comment) + 1, file + " " + tag});
    }
    fresh_.text += "```cpp\n" + wanted.value_or(shown) + "```\n";
  }

  std::optional<std::string> find(std::size_t comment, const std::string& file,
                                  const std::string& tag) {
    const int line = static_cast<int>(comment) + 1;
    const std::optional<std::string> source = read_source_(file);
    if (!source) {
      fresh_.broken.push_back({line, "there is no file " + file});
      return std::nullopt;
    }
    std::optional<std::string> wanted = snippet(*source, tag);
    if (!wanted) {
      fresh_.broken.push_back({line, "// [" + tag + "] must be in " + file + " exactly twice"});
    }
    return wanted;
  }

  std::vector<std::string> lines_;
  ReadSource read_source_;
  FreshText fresh_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<std::string> snippet(std::string_view source, std::string_view tag) {
  static const Pattern any_tag(R"(^\s*// \[[a-z0-9-]+\]\s*$)");
  const std::string wanted = "// [" + std::string(tag) + "]";
  std::vector<std::string> region;
  int seen = 0;
  for (const std::string& line : split_lines(source)) {
    if (trimmed(line) == wanted) {
      ++seen;
    } else if (seen == 1 && !any_tag.match(line)) {
      region.push_back(line);
    }
  }
  if (seen != 2) return std::nullopt;
  return dedented(std::move(region));
}

FreshText with_fresh_snippets(
    std::string_view readme,
    const std::function<std::optional<std::string>(const std::string&)>& read_source) {
  return Refresher(readme, read_source).run();
}

FreshText chapter_with_fresh_snippets(const Home& home, const std::string& chapter) {
  const fs::path folder = home.root / "chapters" / chapter;
  return with_fresh_snippets(
      read_file(folder / "README.md"), [&](const std::string& file) -> std::optional<std::string> {
        const bool is_from_root = file.starts_with("common/") || file.starts_with("chapters/");
        const fs::path path = (is_from_root ? home.root : folder) / file;
        std::error_code ignored;
        if (!fs::is_regular_file(path, ignored)) return std::nullopt;
        return read_file(path);
      });
}

}  // namespace lt
