#include "runner/snippets.hpp"

#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const std::string source =
    "struct Hit {\n"
    "  // [root]\n"
    "  float t;\n"
    "\n"
    "    float u;\n"
    "  // [inner]\n"
    "  float v;\n"
    "  // [inner]\n"
    "  // [root]\n"
    "};\n";

FreshText refreshed(const std::string& readme) {
  return with_fresh_snippets(readme, [](const std::string& file) -> std::optional<std::string> {
    if (file == "hit.hpp") return source;
    return std::nullopt;
  });
}

std::string with_fence(const std::string& code) {
  return "Text.\n<!-- snippet: hit.hpp root -->\n```cpp\n" + code + "```\nMore.\n";
}

const std::string code = "float t;\n\n  float u;\nfloat v;\n";

}  // namespace

TEST_CASE("snippets: a region comes dedented and without tag lines") {
  CHECK(snippet(source, "root") == code);
  CHECK(snippet(source, "inner") == "float v;\n");
  CHECK_FALSE(snippet(source, "nobody"));
  CHECK_FALSE(snippet("// [once]\n", "once"));
  CHECK_FALSE(snippet("// [x]\n// [x]\n// [x]\n", "x"));
}

TEST_CASE("snippets: a fence that is as its file stays, byte for byte") {
  const FreshText fresh = refreshed(with_fence(code));
  CHECK(fresh.text == with_fence(code));
  CHECK(fresh.drifted.empty());
  CHECK(fresh.broken.empty());
}

TEST_CASE("snippets: a planted edit is seen and undone") {
  const FreshText fresh = refreshed(with_fence("float T;\n\n  float u;\nfloat v;\n"));
  REQUIRE(fresh.drifted.size() == 1);
  CHECK(fresh.drifted[0].line == 2);
  CHECK(fresh.drifted[0].what == "hit.hpp root");
  CHECK(fresh.text == with_fence(code));
}

TEST_CASE("snippets: what cannot be refreshed is reported and left alone") {
  for (const char* readme :
       {"<!-- snippet: nobody.hpp root -->\n```cpp\nx\n```\n",
        "<!-- snippet: hit.hpp nobody -->\n```cpp\nx\n```\n",
        "<!-- snippet: hit.hpp root -->\n\n```sh\nx\n```\n",
        "<!-- snippet hit.hpp root -->\n<!-- not compiled: why -->\n```cpp\nx\n```\n",
        "```cpp\nx\n```\n", "```sh\nnever ends\n"}) {
    INFO(readme);
    const FreshText fresh = refreshed(readme);
    CHECK(fresh.broken.size() == 1);
    CHECK(fresh.drifted.empty());
    CHECK(fresh.text == readme);
  }
}

TEST_CASE("snippets: a snippet's fence that never ends is reported") {
  CHECK(refreshed("<!-- snippet: hit.hpp root -->\n```cpp\nx\n").broken.size() == 1);
}

TEST_CASE("snippets: code that says why it is not compiled may stand") {
  const std::string readme =
      "<!-- not compiled: the mistake -->\n```cpp\nfloat t\n```\n```sh\nls\n```\n";
  const FreshText fresh = refreshed(readme);
  CHECK(fresh.broken.empty());
  CHECK(fresh.text == readme);
}
