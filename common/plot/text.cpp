#include "common/plot/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lt {

std::string svg_number(double value) {
  const long long tenths = std::llround(value * 10);
  std::string text = (tenths < 0 ? "-" : "") + std::to_string(std::llabs(tenths) / 10);
  if (tenths % 10 != 0) text += "." + std::to_string(std::llabs(tenths) % 10);
  return text;
}

std::string escape_xml(std::string_view text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&') {
      xml += "&amp;";
    } else if (c == '<') {
      xml += "&lt;";
    } else if (c == '>') {
      xml += "&gt;";
    } else if (c == '"') {
      xml += "&quot;";
    } else {
      xml += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return xml;
}

double text_width(std::string_view text) {
  constexpr std::string_view narrow = " ,.:;'|!()[]iljtfrI";
  constexpr std::string_view wide = "mwMW%@";
  double ems = 0;
  for (const char c : text) {
    const bool continues_a_character = (static_cast<unsigned char>(c) & 0xc0) == 0x80;
    if (continues_a_character) continue;
    if (narrow.find(c) != narrow.npos) {
      ems += 0.38;
    } else if (wide.find(c) != wide.npos) {
      ems += 0.96;
    } else {
      ems += c >= 'A' && c <= 'Z' ? 0.72 : 0.62;
    }
  }
  return ems * font_size;
}

std::vector<std::string> wrap(std::string_view text, double width) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::string word(text.substr(0, text.find(' ')));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (!lines.empty() && text_width(lines.back() + " " + word) <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace lt
