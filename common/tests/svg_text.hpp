// Looks into the text of an SVG.
#pragma once

#include <string>
#include <vector>

namespace lt::test {

/// What stands between each `before` and the next `after`.
inline std::vector<std::string> all_between(const std::string& text, const std::string& before,
                                            const std::string& after) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(before); at != text.npos; at = text.find(before, at)) {
    at += before.size();
    found.push_back(text.substr(at, text.find(after, at) - at));
  }
  return found;
}

}  // namespace lt::test
