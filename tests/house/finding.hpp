/// @file
/// What a check of the house says when something is out of place.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace lt::house {

/// One thing out of place. A check returns all of them, so that one run names them all.
struct Finding {
  std::string file;  ///< from the root, with forward slashes
  int line;          ///< from 1; 0 where the file as a whole is meant
  std::string message;

  bool operator==(const Finding&) const = default;
};

using Findings = std::vector<Finding>;

/// "file:line: message", as compilers write it, so that editors can jump there.
[[nodiscard]] inline std::string to_string(const Finding& finding) {
  const std::string place = finding.line > 0 ? ":" + std::to_string(finding.line) : "";
  return finding.file + place + ": " + finding.message;
}

inline std::ostream& operator<<(std::ostream& out, const Finding& finding) {
  return out << to_string(finding);
}

/// One finding per line.
[[nodiscard]] inline std::string to_string(const Findings& findings) {
  std::string text;
  for (const Finding& finding : findings)
    text += to_string(finding) + "\n";
  return text;
}

}  // namespace lt::house
