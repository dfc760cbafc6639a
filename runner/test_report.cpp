#include "runner/test_report.hpp"

#include "runner/text.hpp"

namespace lt {

namespace {

// The value of an attribute of an XML tag, with its escapes undone.
std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t start = tag.find(" " + name + "=\"");
  if (start == std::string::npos) return "";
  const std::size_t first = start + name.size() + 3;
  std::string value = tag.substr(first, tag.find('"', first) - first);
  for (const auto& [escape, text] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}}) {
    for (std::size_t at = 0; (at = value.find(escape, at)) != std::string::npos; ++at) {
      value.replace(at, std::string_view(escape).size(), text);
    }
  }
  return value;
}

}  // namespace

TestReport read_test_report(std::string_view junit) {
  TestReport report;
  for (const std::string& line : split_lines(junit)) {
    const std::size_t start = line.find("<testcase ");
    if (start == std::string::npos) continue;
    const std::string tag = line.substr(start);
    const std::string status = attribute(tag, "status");
    if (status == "run") {
      ++report.passed;
    } else if (status == "fail") {
      report.failed.push_back(attribute(tag, "name"));
    } else {
      report.not_run.push_back(attribute(tag, "name"));
    }
  }
  return report;
}

}  // namespace lt
