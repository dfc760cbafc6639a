#include <string>

#include "api.hpp"
#include "common/testkit/exercise.hpp"

TEST_CASE("the half of 6 is 3") {
  const double half = exercise::halve(6);
  lt::diagnose(half != 12, "doubled", "halve(6) gave 12, it should give 3");
  lt::diagnose(exercise::halve(5) != 2, "integer-division", "halve(5) gave 2, it should give 2.5");
  CHECK(half == 3);
}

TEST_CASE("two halves are the whole") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    const double x = random.uniform(-10, 10);
    CHECK(2 * exercise::halve(x) == x);
  }
  lt::measured("halve(7) is " + std::to_string(exercise::halve(7)));
}
