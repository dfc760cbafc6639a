#include "tests/house/words.hpp"

#include <algorithm>
#include <cctype>

namespace lt::house {
namespace {

struct Forbidden {
  std::string text;  // lower case; found in any case, not inside a longer word
  std::string why;
};

// Each text is put together from two halves, so that this file does not say it itself.
const std::vector<Forbidden>& forbidden() {
  static const std::string machine = "is a folder of one machine";
  static const std::string registry = "names a package registry's host";
  static const std::string workshop = "speaks of how the course was written, not to its reader";
  static const std::vector<Forbidden> list = {
      {std::string("/wo") + "rk/", machine},
      {std::string("/ro") + "ot/", machine},
      {std::string("/ho") + "me/", machine},
      {std::string("/us") + "ers/", machine},
      {std::string("c:\\us") + "ers\\", machine},
      {std::string("/tm") + "p/", machine},
      {std::string("registry.np") + "mjs.org", registry},
      {std::string("registry.ya") + "rnpkg.com", registry},
      {std::string("deb.de") + "bian.org", registry},
      {std::string("security.de") + "bian.org", registry},
      {std::string("archive.ub") + "untu.com", registry},
      {std::string("py") + "pi.org", registry},
      {std::string("files.pyth") + "onhosted.org", registry},
      {std::string("artifact") + "registry", registry},
      {std::string("sess") + "ion", workshop},
      {std::string("sess") + "ions", workshop},
      {std::string("ag") + "ent", workshop},
      {std::string("ag") + "ents", workshop},
      {std::string("suba") + "gent", workshop},
      {std::string("suba") + "gents", workshop},
      {std::string("work") + "place", workshop},
      {std::string("language ") + "model", workshop},
      {std::string("chat") + "bot", workshop},
      {std::string("chat") + "gpt", workshop},
      {std::string("clau") + "de", workshop},
      {std::string("anth") + "ropic", workshop},
      {std::string("co-authored") + "-by", workshop},
  };
  return list;
}

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

// True where `text` stands in `line` and does not go on as a longer word at either end.
bool says(const std::string& line, const std::string& text) {
  for (std::size_t at = 0; (at = line.find(text, at)) != std::string::npos; ++at) {
    const std::size_t end = at + text.size();
    const bool goes_back = at > 0 && is_word_character(line[at - 1]);
    const bool goes_on =
        is_word_character(text.back()) && end < line.size() && is_word_character(line[end]);
    if (!goes_back && !goes_on) return true;
  }
  return false;
}

}  // namespace

Findings check_words(const Tree& tree) {
  Findings findings;
  for (const std::string& file : tree.files()) {
    if (!is_text(file)) continue;
    int number = 0;
    for (std::string line : tree.lines(file)) {
      ++number;
      std::ranges::transform(line, line.begin(), [](unsigned char c) { return std::tolower(c); });
      for (const Forbidden& word : forbidden()) {
        if (says(line, word.text)) {
          findings.push_back({file, number, '"' + word.text + "\" " + word.why});
        }
      }
    }
  }
  return findings;
}

}  // namespace lt::house
