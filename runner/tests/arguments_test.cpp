#include "runner/arguments.hpp"

#include "common/error.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

TEST_CASE("arguments: options and words in any order") {
  Arguments arguments("verify", {"02.2", "--fair", "--seeds=7"});
  CHECK(arguments.flag("--fair"));
  CHECK_FALSE(arguments.flag("--all"));
  CHECK(arguments.number("--seeds", 200, 1, 1000) == 7);
  CHECK(arguments.words(1) == std::vector<std::string>{"02.2"});
}

TEST_CASE("arguments: a bad number is refused with its range") {
  for (const char* text : {"", "x", "1x", "0", "1001", "-3", "99999999999999999999", "1.5"}) {
    Arguments arguments("verify", {"--seeds", text});
    CHECK_THROWS_AS(arguments.number("--seeds", 200, 1, 1000), InputError);
  }
  Arguments nothing_behind("verify", {"--seeds"});
  CHECK_THROWS_AS(nothing_behind.number("--seeds", 200, 1, 1000), InputError);
}

TEST_CASE("arguments: what nobody took is refused, with the near option") {
  Arguments arguments("solution", {"--anyways"});
  CHECK_FALSE(arguments.flag("--anyway"));
  try {
    arguments.nothing_more();
    FAIL("it must throw");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).find("did you mean --anyway?") != std::string::npos);
  }
  Arguments too_many("run", {"02.1", "02.2"});
  CHECK_THROWS_AS(too_many.word_or_nothing(), InputError);
}

TEST_CASE("arguments: what follows two dashes is somebody else's") {
  Arguments arguments("test", {"--sanitize", "--", "-L", "ch01"});
  CHECK(arguments.after_dashes() == std::vector<std::string>{"-L", "ch01"});
  CHECK(arguments.flag("--sanitize"));
  arguments.nothing_more();
}
