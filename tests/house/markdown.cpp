#include "tests/house/markdown.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

#include "runner/text.hpp"

namespace lt::house {
namespace {

bool is_letter_or_digit(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || std::isalnum(byte) != 0;  // beyond ASCII: taken for letters
}

// Replaces code and formulas within a line by blanks of equal length.
std::string without_spans(std::string line, char mark) {
  for (std::size_t start = 0; (start = line.find(mark, start)) != std::string::npos;) {
    const std::size_t run = std::min(line.find_first_not_of(mark, start), line.size()) - start;
    const std::size_t end = line.find(std::string(run, mark), start + run);
    if (end == std::string::npos) return line;
    std::fill(line.begin() + static_cast<long>(start), line.begin() + static_cast<long>(end + run),
              ' ');
    start = end + run;
  }
  return line;
}

int count_words(const std::string& line) {
  static const std::regex not_said(R"(\]\([^)]*\)|<[^>]*>)");  // link targets, tags
  std::istringstream words(std::regex_replace(line, not_said, " "));
  int count = 0;
  for (std::string word; words >> word;)
    count += std::ranges::any_of(word, is_letter_or_digit);
  return count;
}

// The value of name="value" among a tag's attributes; empty if it is not there.
std::string attribute(const std::string& attributes, const std::string& name) {
  std::smatch match;
  const std::regex form("\\b" + name + "=\"([^\"]*)\"");
  return std::regex_search(attributes, match, form) ? match[1].str() : "";
}

// Reads a page line by line; what a line means depends on what is open above it.
class Reader {
 public:
  Page read(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      ++number_;
      if (!take_fence(line) && !take_formula(line) && !take_comment(line)) take_prose(line);
      above_ = line;
    }
    return std::move(page_);
  }

 private:
  bool take_fence(const std::string& line) {
    const std::size_t first = line.find_first_not_of("> \t");  // a fence may stand in a quotation
    const std::string start = first == std::string::npos ? "" : trimmed(line.substr(first));
    if (!open_fence_.empty()) {
      if (start == open_fence_) {
        open_fence_.clear();
      } else {
        page_.fences.back().body.push_back(line);
      }
      return true;
    }
    if (in_comment_ || !start.starts_with("```")) return false;
    open_fence_ = start.substr(0, start.find_first_not_of('`'));
    const std::string language = trimmed(start.substr(open_fence_.size()));
    page_.fences.push_back({number_, language, trimmed(above_), {}});
    return true;
  }

  bool take_formula(const std::string& line) {
    const bool marks = trimmed(line).starts_with("$$");
    if (!marks && !in_formula_) return false;
    const std::string text = trimmed(line);
    const bool opens_and_closes = marks && text.size() > 2 && text.ends_with("$$");
    if (!opens_and_closes && (marks || text.ends_with("$$"))) in_formula_ = !in_formula_;
    return true;
  }

  bool take_comment(const std::string& line) {
    if (!in_comment_ && !trimmed(line).starts_with("<!--")) return false;
    in_comment_ = line.find("-->") == std::string::npos;
    return true;
  }

  void take_prose(const std::string& line) {
    take_heading(line);
    const std::string plain = without_spans(without_spans(line, '`'), '$');
    take_links(plain, line);
    page_.words += count_words(without_spans(line, '$'));
  }

  void take_heading(const std::string& line) {
    static const std::regex form(R"((#{1,6})\s+(.*?)\s*#*\s*)");
    std::smatch match;
    if (!std::regex_match(line, match, form)) return;
    static const std::regex link_target(R"(\]\([^)]*\))");
    const std::string text = std::regex_replace(match[2].str(), link_target, "]");
    const std::string slug = heading_slug(text);
    const auto same = std::ranges::count_if(
        page_.headings, [&](const Heading& other) { return heading_slug(other.text) == slug; });
    page_.headings.push_back({number_, static_cast<int>(match[1].length()), text,
                              same == 0 ? slug : slug + "-" + std::to_string(same)});
  }

  // `plain` has blanks where `line` has code, so that code is not taken for links.
  void take_links(const std::string& plain, const std::string& line) {
    static const std::regex inline_link(
        R"((!?)\[((?:[^\[\]]|!\[[^\]]*\]\([^)]*\))*)\]\(([^()\s]*)[^()]*\))");
    static const std::regex picture(R"(!\[([^\]]*)\]\(([^()\s]*)[^()]*\))");
    static const std::regex reference(R"(^\s*\[[^\]]+\]:\s+(\S+))");
    const std::sregex_iterator end;
    const auto shown = [&](const std::ssub_match& part) {
      return line.substr(static_cast<std::size_t>(part.first - plain.begin()),
                         static_cast<std::size_t>(part.length()));
    };
    for (std::sregex_iterator it(plain.begin(), plain.end(), picture); it != end; ++it) {
      page_.links.push_back({number_, (*it)[2], shown((*it)[1]), true});
    }
    for (std::sregex_iterator it(plain.begin(), plain.end(), inline_link); it != end; ++it) {
      if ((*it)[1] == "") page_.links.push_back({number_, (*it)[3], shown((*it)[2]), false});
    }
    take_tags(plain);
    std::smatch match;
    if (std::regex_search(plain, match, reference)) {
      page_.links.push_back({number_, match[1], "", false});
    }
  }

  void take_tags(const std::string& plain) {
    static const std::regex tag(R"(<(img|source|a)\b([^>]*)>)");
    for (std::sregex_iterator it(plain.begin(), plain.end(), tag); it != std::sregex_iterator();
         ++it) {
      const std::string name = (*it)[1];
      const std::string attributes = (*it)[2];
      const std::string target = attribute(attributes, name == "a"     ? "href"
                                                       : name == "img" ? "src"
                                                                       : "srcset");
      // A <source> is another form of the <img> beside it, which has the words.
      const std::string text = name == "img" ? attribute(attributes, "alt") : name;
      if (!target.empty()) page_.links.push_back({number_, target, text, name != "a"});
    }
  }

  Page page_;
  std::string above_;
  std::string open_fence_;  // its backticks
  int number_ = 0;
  bool in_formula_ = false;
  bool in_comment_ = false;
};

}  // namespace

bool Page::has_anchor(std::string_view slug) const {
  return std::ranges::any_of(headings, [&](const Heading& h) { return h.slug == slug; });
}

Page parse_markdown(const std::vector<std::string>& lines) {
  return Reader().read(lines);
}

std::string heading_slug(std::string_view text) {
  std::string slug;
  for (const char c : text) {
    if (is_letter_or_digit(c) || c == '-' || c == '_') {
      slug += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (c == ' ') {
      slug += '-';
    }
  }
  return slug;
}

}  // namespace lt::house
