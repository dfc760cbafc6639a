// The shim over Catch2 2.13 and 3.
#include "common/testkit/catch.hpp"

#include <optional>
#include <string_view>

TEST_CASE("catch: GLM vectors and quaternions are printed as numbers") {
  CHECK(Catch::Detail::stringify(glm::vec3(1, -2.5f, 0)) == "(1, -2.5, 0)");
  CHECK(Catch::Detail::stringify(glm::ivec2(3, 4)) == "(3, 4)");
  CHECK(Catch::Detail::stringify(glm::dvec3(0.123456789, 0, 0)) == "(0.123456789, 0, 0)");
  CHECK(Catch::Detail::stringify(glm::quat(1, 0, 0.5f, 0)) == "(w 1, 0, 0.5, 0)");
}

TEST_CASE("catch: what the course's tests use is there in both versions") {
  const auto value = GENERATE(1, 2, 3);
  const auto even = GENERATE(range(2, 6, 2));
  INFO("value " << value);
  CAPTURE(even);
  CHECK(Approx(1.0 * value).margin(1e-3) == value + 5e-4);
  CHECK(std::string_view("printed") == "printed");
  CHECK(std::optional<int>(value) == value);
  CHECK(even % 2 == 0);
  SECTION("sections work") {
    CHECK_THROWS_AS(throw std::runtime_error("as planned"), std::runtime_error);
    CHECK_NOTHROW(value);
  }
}
