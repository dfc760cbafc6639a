// The half of verdict.hpp that reads what a test program and Catch2's report say.
#include <algorithm>
#include <regex>

#include "common/files.hpp"
#include "runner/text.hpp"
#include "runner/verdict.hpp"

namespace lt {

std::set<std::string> TestOutput::tags() const {
  std::set<std::string> tags;
  for (const Finding& finding : findings)
    tags.insert(finding.tag);
  return tags;
}

namespace {

// What stands behind `mark` in the line, if the mark is there. A learner's own output without a
// newline may stand before it.
std::optional<std::string> after(const std::string& line, std::string_view mark) {
  const std::size_t start = line.find(mark);
  if (start == std::string::npos) return std::nullopt;
  return line.substr(start + mark.size());
}

std::optional<NotWrittenYet> parse_not_written(const std::string& rest) {
  static const std::regex pattern(R"( ?(.+?):(\d{1,7}): (.*))");
  std::smatch match;
  if (!std::regex_match(rest, match, pattern)) return std::nullopt;
  return NotWrittenYet{match[1], std::stoi(match[2]), match[3]};
}

std::optional<Finding> parse_finding(const std::string& rest) {
  const std::size_t end = rest.find(']');
  if (end == std::string::npos) return std::nullopt;
  return Finding{rest.substr(0, end), trimmed(rest.substr(end + 1))};
}

// The sentence of the last TEST_CASE at or above a line of test.cpp.
std::string test_case_above(const std::vector<std::string>& lines, int line) {
  static const std::regex pattern(R"(^\s*TEST_CASE\(\s*"([^"]*)\")");
  std::string sentence;
  for (int i = 0; i < std::min(line, static_cast<int>(lines.size())); ++i) {
    std::smatch match;
    if (std::regex_search(lines[static_cast<std::size_t>(i)], match, pattern)) sentence = match[1];
  }
  return sentence;
}

// Splits Catch2's "EXPRESSION for: VALUES with 2 messages: 'a' and 'b'".
void split_failure(std::string text, FailedCheck& check) {
  static const std::regex messages(R"( with \d+ messages?: (.*)$)");
  static const std::regex thrown(
      R"(^unexpected exception with messages?: '(.*?)'(?: and .*)?(?:; expression was: (.*))?$)");
  std::smatch match;
  if (std::regex_match(text, match, thrown)) {
    check.message = "an exception came out: " + match[1].str();
    check.expression = match[2];
    return;
  }
  if (std::regex_search(text, match, messages)) {
    check.message = match[1];
    const bool is_one = match.str().starts_with(" with 1 ") && check.message.size() >= 2;
    if (is_one) check.message = check.message.substr(1, check.message.size() - 2);  // its quotes
    text = match.prefix();
  }
  const std::size_t values = text.find(" for: ");
  check.expression = text.substr(0, values);
  if (values != std::string::npos) check.values = text.substr(values + 6);
  if (check.expression == "explicitly") check.expression.clear();
}

// The first failure in Catch2's compact report, on one line: Catch2 breaks long values into
// several.
std::optional<std::string> first_failure(std::string_view report) {
  static const std::regex start(R"(^.*?[:(]\d{1,7}\)?: failed: .*$)");
  static const std::regex end(R"(^(?:.*?[:(]\d{1,7}\)?: (?:failed|passed): .*|Failed \d.*|)$)");
  constexpr std::size_t longest = 2000;  // std::regex calls itself once for each character
  std::optional<std::string> failure;
  for (std::string line : split_lines(report)) {
    line.resize(std::min(line.size(), longest));
    if (!failure) {
      if (std::regex_match(line, start)) failure = line;
    } else if (std::regex_match(line, end)) {
      break;
    } else {
      *failure += " " + trimmed(line);
    }
  }
  if (failure) failure->resize(std::min(failure->size(), longest));
  return failure;
}

std::optional<FailedCheck> first_failed_check(std::string_view report, std::string_view test_cpp) {
  static const std::regex pattern(R"(^.*?[:(](\d{1,7})\)?: failed: (.*)$)");
  const std::optional<std::string> failure = first_failure(report);
  std::smatch match;
  if (!failure || !std::regex_match(*failure, match, pattern)) return std::nullopt;
  FailedCheck check;
  check.line = std::stoi(match[1]);
  check.sentence = test_case_above(split_lines(test_cpp), check.line);
  split_failure(match[2], check);
  return check;
}

}  // namespace

TestOutput read_test_output(std::string_view output, std::string_view report,
                            std::string_view test_cpp) {
  TestOutput result;
  for (const std::string& line : split_lines(output)) {
    if (const auto rest = after(line, "[not-written]")) {
      if (!result.not_written) {
        result.not_written = parse_not_written(*rest);
        result.is_todo_first = result.findings.empty();
      }
    } else if (const auto diagnosed = after(line, "[diag:")) {
      if (const auto finding = parse_finding(*diagnosed)) result.findings.push_back(*finding);
    } else if (const auto fact = after(line, "[measured] ")) {
      result.measured.push_back(*fact);
    } else {
      result.printed.push_back(printable(line));
    }
  }
  result.failed_check = first_failed_check(report, test_cpp);
  return result;
}

}  // namespace lt
