#include "tests/house/markdown.hpp"

#include "common/testkit/catch.hpp"
#include "runner/text.hpp"

using namespace lt::house;

namespace {

Page page_of(const std::string& text) {
  return parse_markdown(lt::split_lines(text));
}

}  // namespace

TEST_CASE("markdown: a heading's anchor is GitHub's") {
  // The rule is GitHub's own: lower case, blanks to hyphens, all other punctuation dropped.
  CHECK(heading_slug("Does it hold?") == "does-it-hold");
  CHECK(heading_slug("2. Ray casting") == "2-ray-casting");
  CHECK(heading_slug("The `Hit` & the ray") == "the-hit--the-ray");
  CHECK(heading_slug("snake_case stays") == "snake_case-stays");
}

TEST_CASE("markdown: equal headings get numbered anchors") {
  const Page page = page_of("# One\n## Look\n## Look\n## Look\n");
  REQUIRE(page.headings.size() == 4);
  CHECK(page.headings[1].slug == "look");
  CHECK(page.headings[2].slug == "look-1");
  CHECK(page.headings[3].slug == "look-2");
  CHECK(page.headings[3].line == 4);
  CHECK(page.has_anchor("look-2"));
  CHECK_FALSE(page.has_anchor("look-3"));
}

TEST_CASE("markdown: links and pictures are told apart") {
  const Page page = page_of("See [a](a.md#b) and ![c](c.png).\n\n[![d](d.png)](e.md \"title\")\n");
  REQUIRE(page.links.size() == 4);
  CHECK(page.links[0].target == "c.png");
  CHECK(page.links[0].is_picture);
  CHECK(page.links[0].text == "c");
  CHECK(page.links[1].target == "a.md#b");
  CHECK_FALSE(page.links[1].is_picture);
  CHECK(page.links[2].target == "d.png");
  CHECK(page.links[3].target == "e.md");
  CHECK(page.links[3].line == 3);
}

TEST_CASE("markdown: links of HTML and of references are seen") {
  const Page page = page_of("<img src=\"a.png\" alt=\"A\"><a href=\"b.md\">b</a>\n\n[c]: c.md\n");
  REQUIRE(page.links.size() == 3);
  CHECK(page.links[0].target == "a.png");
  CHECK(page.links[0].is_picture);
  CHECK(page.links[0].text == "A");
  CHECK(page.links[1].target == "b.md");
  CHECK(page.links[2].target == "c.md");
}

TEST_CASE("markdown: code, formulas and comments hold no links and no headings") {
  const Page page = page_of(
      "```sh\n# no heading\n[no](link)\n```\n`[no](link)` $[a](b)$\n$$\n[a](b)\n$$\n"
      "<!-- [no](link)\n# still none\n-->\n");
  CHECK(page.links.empty());
  CHECK(page.headings.empty());
}

TEST_CASE("markdown: a fence knows its language, its body and the line above") {
  const Page page = page_of("<!-- snippet: a.hpp b -->\n```cpp\nint a;\n\nint b;\n```\n");
  REQUIRE(page.fences.size() == 1);
  CHECK(page.fences[0].language == "cpp");
  CHECK(page.fences[0].before == "<!-- snippet: a.hpp b -->");
  CHECK(page.fences[0].line == 2);
  CHECK(page.fences[0].body == std::vector<std::string>{"int a;", "", "int b;"});
}

TEST_CASE("markdown: words are counted in prose and tables only") {
  CHECK(page_of("# Two words\n\nThree more words, [a link](not/counted.md).\n").words == 7);
  CHECK(page_of("| a | b |\n|---|---|\n| c | d |\n").words == 4);
  CHECK(page_of("```\nnot one\n```\n$$\nnot one\n$$\n<!-- not one -->\nnor $x + y$\n").words == 1);
}
