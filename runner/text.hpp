/// @file
/// Small tools for lines of text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lt {

/// The lines of a text without their ends; a trailing newline makes no empty last line.
[[nodiscard]] std::vector<std::string> split_lines(std::string_view text);

[[nodiscard]] std::string join(const std::vector<std::string>& parts, std::string_view between);

[[nodiscard]] std::string trimmed(std::string_view text);

/// The text broken at spaces into lines of at most `width` characters, each after `indent` spaces;
/// newlines in the text stay. A longer word gets a line of its own.
[[nodiscard]] std::string wrapped(std::string_view text, int width, int indent);

/// The text with spaces behind it, at least `width` characters long.
[[nodiscard]] std::string padded(std::string_view text, int width);

/// Bytes as people write them: "812 B", "34 KB", "1.2 MB".
[[nodiscard]] std::string human_size(std::size_t bytes);

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other
/// (Damerau and Levenshtein's restricted distance).
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The choices that someone who typed `word` may have meant: the nearest, at most three.
[[nodiscard]] std::vector<std::string> near_words(std::string_view word,
                                                  const std::vector<std::string>& choices);

/// ": did you mean a or b?", or "; OTHERWISE" if nothing is near (nothing if `otherwise` is empty).
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string>& choices,
                                       const std::string& otherwise = "");

/// A number that changes when the bytes change (FNV-1a, 64 bits), as 16 hexadecimal digits.
[[nodiscard]] std::string fingerprint(std::string_view bytes);

}  // namespace lt
