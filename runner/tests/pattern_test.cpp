#include "runner/pattern.hpp"
#include "common/testkit/catch.hpp"

using lt::Pattern;

TEST_CASE("a pattern matches the whole text or finds a place in it") {
  const Pattern number("([a-z]+)-?([0-9])?");
  CHECK(number.match("ab-7") == Pattern::Groups{"ab-7", "ab", "7"});
  CHECK_FALSE(number.match("(ab-7)"));
  CHECK(number.search("(ab-7) cd-8") == Pattern::Groups{"ab-7", "ab", "7"});
  CHECK_FALSE(number.search("12"));
}

TEST_CASE("a group that took no part in a match is empty") {
  CHECK(Pattern("(a)|(b)").match("b") == Pattern::Groups{"b", "", "b"});
}
