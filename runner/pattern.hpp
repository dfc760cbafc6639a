/// @file
/// Regular expressions. <regex> takes a compiler seconds, so that one file alone includes it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lt {

/// A regular expression in ECMAScript's grammar (std::regex), compiled once.
class Pattern {
 public:
  /// What a match found: [0] is all of it, [1] the first group; a group that took no part is empty.
  using Groups = std::vector<std::string>;

  /// Throws std::regex_error where the expression is wrong.
  explicit Pattern(const char* expression);
  ~Pattern();
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;

  /// The groups if the expression matches all of the text. std::regex calls itself once for each
  /// character: give it lines, not files.
  [[nodiscard]] std::optional<Groups> match(const std::string& text) const;

  /// The groups of the first place in the text that matches.
  [[nodiscard]] std::optional<Groups> search(const std::string& text) const;

 private:
  struct Compiled;
  std::unique_ptr<const Compiled> compiled_;
};

}  // namespace lt
