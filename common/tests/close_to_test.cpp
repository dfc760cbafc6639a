#include "common/testkit/close_to.hpp"

#include <limits>

using lt::close_to;

TEST_CASE("close to: as far as the tolerance and no farther, either way") {
  CHECK(2.25 == close_to(2.0, 0.25));
  CHECK(1.75 == close_to(2.0, 0.25));
  CHECK_FALSE(2.26 == close_to(2.0, 0.25));
  CHECK_FALSE(1.74 == close_to(2.0, 0.25));
  CHECK(2.5f == close_to(2.25, 0.25));  // float against double
}

TEST_CASE("close to: vectors are as far apart as their difference is long") {
  const glm::dvec3 v(1, 2, 3);
  CHECK(v == close_to(v + glm::dvec3(0.3, 0.0, 0.4), 0.5001));  // 3, 4, 5
  CHECK_FALSE(v == close_to(v + glm::dvec3(0.3, 0.0, 0.4), 0.4999));
}

TEST_CASE("close to: nothing is close to NaN") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(nan == close_to(0.0, 1e9));
  CHECK_FALSE(0.0 == close_to(nan, 1e9));
  CHECK_FALSE(glm::dvec2(0, nan) == close_to(glm::dvec2(0), 1e9));
}

TEST_CASE("close to: a failing check shows the value") {
  CHECK(Catch::Detail::stringify(close_to(0.75)) == "close to 0.75");
  CHECK(Catch::Detail::stringify(close_to(glm::dvec2(0.75, 0.5))) == "close to (0.75, 0.5)");
}
