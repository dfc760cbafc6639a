// The half of verdict.hpp that reads what compilers and linkers print: GCC, Clang and MSVC.

#include "runner/pattern.hpp"
#include "runner/text.hpp"
#include "runner/verdict.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

// One "file:line:column: error: message" or "file(line,column): error C1234: message".
struct Remark {
  std::string file;
  int line = 0;
  int column = 0;
  std::string kind;
  std::string message;
};

std::optional<Remark> parse_remark(const std::string& line) {
  static const Pattern gnu(R"(^(.+?):(\d{1,7})(?::(\d{1,5}))?: +(.*)$)");
  static const Pattern msvc(R"(^(.+?)\((\d{1,7})(?:,(\d{1,5}))?\): +(.*)$)");
  static const Pattern kind(R"(^((?:fatal )?error|warning|note)(?: [A-Z]+\d+)?: (.*)$)");
  auto found = gnu.match(line);
  if (!found) found = msvc.match(line);
  if (!found) return std::nullopt;
  const Pattern::Groups& part = *found;
  Remark remark{part[1], std::stoi(part[2]), part[3].empty() ? 0 : std::stoi(part[3]), "", part[4]};
  if (const auto kinds = kind.match(remark.message)) {
    remark.kind = (*kinds)[1];
    remark.message = (*kinds)[2];
  }
  return remark;
}

// Either kind of slash.
std::string file_name(const std::string& path) {
  return path.substr(path.find_last_of("/\\") + 1);
}

// GCC and Clang show the line of code below their message: "   12 |   code" or "  code".
std::string code_below(const std::vector<std::string>& lines, std::size_t index) {
  static const Pattern numbered(R"(^ *\d+ \| ?(.*)$)");
  if (index + 1 >= lines.size()) return "";
  if (const auto found = numbered.match(lines[index + 1])) return (*found)[1];
  const bool is_caret_next =
      index + 2 < lines.size() && lines[index + 2].find('^') != std::string::npos;
  return is_caret_next ? lines[index + 1] : "";
}

std::optional<BuildError> link_error(const std::vector<std::string>& lines) {
  static const Pattern missing(R"((?:undefined reference to|undefined symbol:) [`'"]?(.*?)['"]?$)");
  static const Pattern twice(R"(multiple definition of [`'"](.*?)['"])");
  for (const std::string& line : lines) {
    if (const auto found = missing.search(line)) {
      return BuildError{0, 0,
                        (*found)[1] +
                            " is declared in api.hpp, but your file does not define "
                            "it: compare name, parameters, const and namespace.",
                        ""};
    }
    if (const auto found = twice.search(line)) {
      return BuildError{0, 0, (*found)[1] + " is defined twice.", ""};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<BuildError> first_build_error(std::string_view output, const fs::path& answer) {
  const std::vector<std::string> lines = split_lines(output);
  // An error inside a library's template names the learner's line before or after it: keep the
  // last place in the learner's file that was mentioned.
  std::optional<Remark> mention;
  std::optional<BuildError> foreign;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::optional<Remark> remark = parse_remark(lines[i]);
    if (!remark) continue;
    const bool is_mine = file_name(remark->file) == answer.filename();
    const bool is_error = remark->kind.ends_with("error");
    if (is_mine && is_error) {
      return BuildError{remark->line, remark->column, remark->message, code_below(lines, i)};
    }
    if (is_mine && foreign && foreign->line == 0) foreign->line = remark->line;
    if (is_mine && remark->kind.empty()) mention = remark;
    if (is_error && !foreign) {
      foreign = BuildError{mention ? mention->line : 0, 0, remark->message, ""};
    }
  }
  if (foreign && foreign->line > 0) return foreign;
  return link_error(lines);
}

}  // namespace lt
