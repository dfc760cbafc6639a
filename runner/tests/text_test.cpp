#include "runner/text.hpp"

#include "common/testkit/catch.hpp"

using namespace lt;

TEST_CASE("text: edit distance counts insertions, deletions, replacements and swaps") {
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("hint", "hint") == 0);
  CHECK(edit_distance("hnit", "hint") == 1);
  CHECK(edit_distance("hnt", "hint") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);  // Levenshtein's own example
}

TEST_CASE("text: did you mean the nearest ones") {
  const std::vector<std::string> commands{"hint", "list", "next", "render", "reset", "run", "test"};
  CHECK(did_you_mean("lsit", commands) == ": did you mean list?");
  CHECK(did_you_mean("rend", commands, "see help") == ": did you mean render?");
  CHECK(did_you_mean("rest", commands) == ": did you mean reset or test?");
  CHECK(did_you_mean("photosynthesis", commands, "see help") == "; see help");
  CHECK(did_you_mean("photosynthesis", commands).empty());
  CHECK(did_you_mean("", commands).empty());
}

TEST_CASE("text: wrapped lines keep words whole and within the width") {
  const std::string text = wrapped("one two three four five six", 12, 2);
  CHECK(text == "  one two\n  three four\n  five six\n");
  CHECK(wrapped("incomprehensibilities", 10, 1) == " incomprehensibilities\n");
  CHECK(wrapped("", 10, 2).empty());
}

TEST_CASE("text: lines with every kind of end") {
  CHECK(split_lines("a\r\nb\nc") == std::vector<std::string>{"a", "b", "c"});
  CHECK(split_lines("a\n\n") == std::vector<std::string>{"a", ""});
  CHECK(split_lines("").empty());
}

TEST_CASE("text: the fingerprint is FNV-1a of 64 bits") {
  // Fowler, Noll and Vo's published test vectors.
  CHECK(fingerprint("") == "cbf29ce484222325");
  CHECK(fingerprint("a") == "af63dc4c8601ec8c");
  CHECK(fingerprint("foobar") == "85944171f73967e8");
}

TEST_CASE("text: sizes as people write them") {
  CHECK(human_size(812) == "812 B");
  CHECK(human_size(34'400) == "34 KB");
  CHECK(human_size(1'250'000) == "1.2 MB");
}
