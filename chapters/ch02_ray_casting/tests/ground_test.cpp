#include "ch02_ray_casting/ground.hpp"

#include "ch02_ray_casting/tests/reference.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const Ground ground{0.5f};

}  // namespace

TEST_CASE("ground: from above and from below") {
  const float slant = std::sqrt(0.5f);
  CHECK(*intersect(ground, Ray{{1, 3, 1}, {0, -1, 0}}, infinity) == 2.5f);
  CHECK(*intersect(ground, Ray{{1, -3, 1}, {0, 1, 0}}, infinity) == 3.5f);
  CHECK(*intersect(ground, Ray{{1, 3, 1}, {slant, -slant, 0}}, infinity) ==
        Approx(2.5 * std::sqrt(2.0)).epsilon(1e-6));
}

TEST_CASE("ground: a ray that goes away from it misses") {
  CHECK_FALSE(intersect(ground, Ray{{1, 3, 1}, {0, 1, 0}}, infinity));
  CHECK_FALSE(intersect(ground, Ray{{1, -3, 1}, {0, -1, 0}}, infinity));
}

TEST_CASE("ground: a level ray misses from above and below and within") {
  for (const vec3 d : cube_directions())
    for (const float y : {0.0f, 0.5f, 1.0f})
      if (d.y == 0.0f) CHECK_FALSE(intersect(ground, Ray{{0, y, 0}, d}, infinity));
}

TEST_CASE("ground: a ray that starts on it does not hit it") {
  for (const vec3 d : cube_directions())
    CHECK_FALSE(intersect(ground, Ray{{7, 0.5f, -2}, d}, infinity));
}

TEST_CASE("ground: t_max itself does not count") {
  const Ray ray{{0, 3, 0}, {0, -1, 0}};
  CHECK(intersect(ground, ray, std::nextafter(2.5f, 3.0f)));
  CHECK_FALSE(intersect(ground, ray, 2.5f));
}

TEST_CASE("ground: a nearly level ray hits it far away") {
  // Down by 1 m in a million: from 1 m above, the hit is a million metres away.
  const auto t = intersect(Ground{0.0f}, Ray{{0, 1, 0}, {1.0f, -1e-6f, 0.0f}}, infinity);
  REQUIRE(t);
  CHECK(*t == Approx(1e6).epsilon(1e-6));
}

// One difference and one quotient: two roundings of 2^-24 each, relative to t.
TEST_CASE("ground: agrees with double within two roundings") {
  RandomCases random(8);
  for (int i = 0; i < 200'000; ++i) {
    const Ground level{random.uniform(-10.0f, 10.0f)};
    const Ray ray{random.point_within(random.any_size(-3.0f, 6.0f)), random.direction()};
    const double expected = reference::ground_t(level, ray);
    const auto t = intersect(level, ray, infinity);
    REQUIRE(t.has_value() == (expected > 0));
    if (t) REQUIRE(std::abs(*t - expected) <= 2.001 * reference::u * expected);
  }
}
