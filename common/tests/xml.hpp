// A strict little reader for the XML that our plots are made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lt::test {

/// Checks that a document is well-formed (XML 1.0, as far as our plots use it), tag by tag.
class XmlCheck {
 public:
  explicit XmlCheck(std::string_view document) : rest_(document) {
    while (problem_.empty() && !rest_.empty()) {
      if (rest_[0] == '<') {
        tag();
      } else {
        text(rest_.substr(0, rest_.find('<')), "text");
        rest_.remove_prefix(std::min(rest_.find('<'), rest_.size()));
      }
    }
    if (problem_.empty() && !open_.empty()) problem_ = "not closed: " + open_.back();
    if (problem_.empty() && roots_ != 1) problem_ = "not exactly one root";
  }

  /// Empty if the document is well-formed.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  static bool is_name(std::string_view name) {
    constexpr std::string_view letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
    return !name.empty() && name.find_first_not_of(letters) == name.npos;
  }

  void text(std::string_view text, const std::string& where) {
    if (open_.empty() && text.find_first_not_of("\n") != text.npos) problem_ = "text outside";
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto c = static_cast<unsigned char>(text[i]);
      if (c < 0x20 && c != '\n') problem_ = "control character in " + where;
      if (c == '<') problem_ = "< in " + where;
      if (c != '&') continue;
      bool is_known = false;
      for (const std::string_view known : {"&amp;", "&lt;", "&gt;", "&quot;"})
        is_known = is_known || text.substr(i, known.size()) == known;
      if (!is_known) problem_ = "bare & in " + where;
    }
  }

  // <name a="b" c="d">, <name/> or </name>
  void tag() {
    const std::size_t end = rest_.find('>');
    if (end == rest_.npos) {
      problem_ = "a tag does not end";
      return;
    }
    std::string_view inside = rest_.substr(1, end - 1);
    rest_.remove_prefix(end + 1);
    if (!inside.empty() && inside[0] == '/') {
      if (open_.empty() || open_.back() != inside.substr(1))
        problem_ = "closes what is not open: " + std::string(inside);
      else
        open_.pop_back();
      return;
    }
    const bool closes_itself = !inside.empty() && inside.back() == '/';
    if (closes_itself) inside.remove_suffix(1);
    const std::string name(inside.substr(0, inside.find(' ')));
    if (!is_name(name)) problem_ = "no name of a tag: " + name;
    if (open_.empty()) ++roots_;
    open_.push_back(name);
    attributes(inside.substr(name.size()), name);
    if (closes_itself) open_.pop_back();
  }

  void attributes(std::string_view list, const std::string& tag) {
    std::vector<std::string> seen;
    while (!list.empty() && problem_.empty()) {
      const std::size_t equals = list.find("=\"");
      const std::size_t end = equals == list.npos ? list.npos : list.find('"', equals + 2);
      if (list[0] != ' ' || end == list.npos || !is_name(list.substr(1, equals - 1))) {
        problem_ = "attributes of " + tag;
        return;
      }
      const std::string name(list.substr(1, equals - 1));
      for (const std::string& other : seen)
        if (other == name) problem_ = name + " twice in " + tag;
      seen.push_back(name);
      text(list.substr(equals + 2, end - equals - 2), name + " of " + tag);
      list.remove_prefix(end + 1);
    }
  }

  std::string_view rest_;
  std::vector<std::string> open_;
  std::string problem_;
  int roots_ = 0;
};

}  // namespace lt::test
