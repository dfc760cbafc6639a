#include "runner/text.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <sstream>

namespace lt {

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.emplace_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string join(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += between;
    text += parts[i];
  }
  return text;
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

std::string wrapped(std::string_view text, int width, int indent) {
  std::string result;
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  for (const std::string& paragraph : split_lines(text)) {
    std::string line;
    std::istringstream words(paragraph);
    for (std::string word; words >> word;) {
      if (!line.empty() && indent + static_cast<int>(line.size() + 1 + word.size()) > width) {
        result += margin + line + '\n';
        line.clear();
      }
      line += (line.empty() ? "" : " ") + word;
    }
    result += (line.empty() ? "" : margin) + line + '\n';
  }
  return result;
}

std::string padded(std::string_view text, int width) {
  std::string result(text);
  if (static_cast<int>(result.size()) < width) result.resize(static_cast<std::size_t>(width), ' ');
  return result;
}

std::string human_size(std::size_t bytes) {
  char text[32];
  if (bytes < 1000) {
    std::snprintf(text, sizeof text, "%zu B", bytes);
  } else if (bytes < 1'000'000) {
    std::snprintf(text, sizeof text, "%.0f KB", static_cast<double>(bytes) / 1e3);
  } else {
    std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) / 1e6);
  }
  return text;
}

int edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table: two rows back (for swaps), the row above, and this one.
  std::vector<int> before_above, above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_above[j - 2] + 1);
      }
    }
    before_above = above;
    above = row;
  }
  return above[b.size()];
}

std::vector<std::string> near_words(std::string_view word,
                                    const std::vector<std::string>& choices) {
  std::vector<std::pair<int, std::string>> found;
  for (const std::string& choice : choices) {
    const bool is_start = word.size() >= 2 && choice.starts_with(word);
    const int distance = is_start ? 0 : edit_distance(word, choice);
    if (distance <= (word.size() <= 3 ? 1 : 2)) found.emplace_back(distance, choice);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> words;
  for (const auto& [distance, choice] : found) {
    if (words.size() < 3 && distance == found.front().first) words.push_back(choice);
  }
  return words;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& choices,
                         const std::string& otherwise) {
  const std::vector<std::string> words = near_words(word, choices);
  if (!words.empty()) return ": did you mean " + join(words, " or ") + "?";
  return otherwise.empty() ? "" : "; " + otherwise;
}

std::string fingerprint(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace lt
