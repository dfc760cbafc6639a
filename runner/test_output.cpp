// The half of verdict.hpp that reads what a test program and Catch2's report say.
#include <algorithm>

#include "common/files.hpp"
#include "runner/pattern.hpp"
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
  static const Pattern pattern(R"( ?(.+?):(\d{1,7}): (.*))");
  const auto found = pattern.match(rest);
  if (!found) return std::nullopt;
  return NotWrittenYet{(*found)[1], std::stoi((*found)[2]), (*found)[3]};
}

std::optional<Finding> parse_finding(const std::string& rest) {
  const std::size_t end = rest.find(']');
  if (end == std::string::npos) return std::nullopt;
  return Finding{rest.substr(0, end), trimmed(rest.substr(end + 1))};
}

// The sentence of the last TEST_CASE at or above a line of test.cpp.
std::string test_case_above(const std::vector<std::string>& lines, int line) {
  static const Pattern pattern(R"(^\s*TEST_CASE\(\s*"([^"]*)\")");
  std::string sentence;
  for (int i = 0; i < std::min(line, static_cast<int>(lines.size())); ++i) {
    const auto found = pattern.search(lines[static_cast<std::size_t>(i)]);
    if (found) sentence = (*found)[1];
  }
  return sentence;
}

// Splits Catch2's "EXPRESSION for: VALUES with 2 messages: 'a' and 'b'".
void split_failure(std::string text, FailedCheck& check) {
  static const Pattern messages(R"( with \d+ messages?: (.*)$)");
  static const Pattern thrown(
      R"(^unexpected exception with messages?: '(.*?)'(?: and .*)?(?:; expression was: (.*))?$)");
  if (const auto found = thrown.match(text)) {
    check.message = "an exception came out: " + (*found)[1];
    check.expression = (*found)[2];
    return;
  }
  if (const auto found = messages.search(text)) {
    const std::string& tail = (*found)[0];
    check.message = (*found)[1];
    const bool is_one = tail.starts_with(" with 1 ") && check.message.size() >= 2;
    if (is_one) check.message = check.message.substr(1, check.message.size() - 2);  // its quotes
    text.resize(text.size() - tail.size());
  }
  const std::size_t values = text.find(" for: ");
  check.expression = text.substr(0, values);
  if (values != std::string::npos) check.values = text.substr(values + 6);
  if (check.expression == "explicitly") check.expression.clear();
}

// The first failure in Catch2's compact report, on one line: Catch2 breaks long values into
// several.
std::optional<std::string> first_failure(std::string_view report) {
  static const Pattern start(R"(^.*?[:(]\d{1,7}\)?: failed: .*$)");
  static const Pattern end(R"(^(?:.*?[:(]\d{1,7}\)?: (?:failed|passed): .*|Failed \d.*|)$)");
  constexpr std::size_t longest = 2000;  // std::regex calls itself once for each character
  std::optional<std::string> failure;
  for (std::string line : split_lines(report)) {
    line.resize(std::min(line.size(), longest));
    if (!failure) {
      if (start.match(line)) failure = line;
    } else if (end.match(line)) {
      break;
    } else {
      *failure += " " + trimmed(line);
    }
  }
  if (failure) failure->resize(std::min(failure->size(), longest));
  return failure;
}

std::optional<FailedCheck> first_failed_check(std::string_view report, std::string_view test_cpp) {
  static const Pattern pattern(R"(^.*?[:(](\d{1,7})\)?: failed: (.*)$)");
  const std::optional<std::string> failure = first_failure(report);
  const auto found = failure ? pattern.match(*failure) : std::nullopt;
  if (!found) return std::nullopt;
  FailedCheck check;
  check.line = std::stoi((*found)[1]);
  check.sentence = test_case_above(split_lines(test_cpp), check.line);
  split_failure((*found)[2], check);
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
