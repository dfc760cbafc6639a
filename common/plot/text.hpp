/// @file
/// Words and numbers inside an SVG. Part of plot.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lt {

/// Size of all words in a plot, in units of its viewBox: half of it in pixels on a phone.
inline constexpr double font_size = 20;
inline constexpr double line_height = 23;

/// A length with one decimal, as SVG wants it.
[[nodiscard]] std::string svg_number(double value);

/// `text` as XML: markup escaped, control characters turned into spaces.
[[nodiscard]] std::string escape_xml(std::string_view text);

/// About how wide `text` (UTF-8) is in a system font; rather too wide than too narrow.
[[nodiscard]] double text_width(std::string_view text);

/// Breaks `text` between words into lines at most `width` wide, unless one word alone is wider.
[[nodiscard]] std::vector<std::string> wrap(std::string_view text, double width);

}  // namespace lt
