/// @file
/// As much of GitHub's Markdown as the checks need: headings, links, code fences, words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lt::house {

struct Heading {
  int line;
  int level;         ///< 1 for #, 2 for ##
  std::string text;  ///< without marks
  std::string slug;  ///< what follows # in a link to it, unique in its page
};

struct Link {
  int line;
  std::string target;  ///< as written, without a title
  std::string text;    ///< what is shown; for a picture: said to those who cannot see it
  bool is_picture;
};

/// A block between two lines of ```.
struct Fence {
  int line;              ///< of the opening ```
  std::string language;  ///< "cpp", or empty
  std::string before;    ///< the line directly above
  std::vector<std::string> body;
};

struct Page {
  std::vector<Heading> headings;
  std::vector<Link> links;
  std::vector<Fence> fences;
  int words = 0;  ///< of prose and tables: no code blocks, no formulas, no comments

  [[nodiscard]] bool has_anchor(std::string_view slug) const;
};

[[nodiscard]] Page parse_markdown(const std::vector<std::string>& lines);

/// GitHub's anchor of a heading: lower case, blanks to hyphens, punctuation dropped.
[[nodiscard]] std::string heading_slug(std::string_view text);

}  // namespace lt::house
