#include <numbers>

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch05_rendering_equation/radiance.hpp"
#include "ch05_rendering_equation/uniform_hemisphere.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const vec3 up(0, 1, 0);

// A floor at y = 0 whose bump tilts the shading normal to (0.6, 0.8, 0).
Surface bumped_floor(bool from_above = true) {
  Surface floor{};
  floor.point = {vec3(0.0f), up, 1e-6f};
  floor.outside = from_above;
  floor.frame = frame_around({0.6f, 0.8f, 0.0f});
  if (!from_above) floor.frame = seen_from_behind(floor.frame);
  return floor;
}

std::optional<Ray> next_towards(const Surface& floor, vec3 wo, vec3 direction) {
  const vec3 unit = normalize(direction);
  return next_ray(floor, wo, floor.frame.to_local(unit));
}

}  // namespace

TEST_CASE("next ray: it goes where wi points and starts off the surface on that side") {
  const auto above = next_towards(bumped_floor(), up, {0.1f, 1.0f, 0.2f});
  REQUIRE(above);
  CHECK(length(above->direction - normalize(vec3(0.1f, 1.0f, 0.2f))) < 1e-6f);
  CHECK(above->origin.y > 0.0f);
  const auto below = next_towards(bumped_floor(), up, {0.1f, -1.0f, 0.2f});
  REQUIRE(below);  // refraction, one day
  CHECK(below->origin.y < 0.0f);
}

TEST_CASE("next ray: a reflection off a bump that would enter the floor is refused") {
  // (1, -0.1, 0) . (0.6, 0.8, 0) = 0.52: before the bump, yet below the floor.
  CHECK_FALSE(next_towards(bumped_floor(), up, {1.0f, -0.1f, 0.0f}));
}

TEST_CASE("next ray: a transmission through a bump that would stay above the floor is refused") {
  // (-1, 0.3, 0) . (0.6, 0.8, 0) = -0.36: behind the bump, yet above the floor.
  CHECK_FALSE(next_towards(bumped_floor(), up, {-1.0f, 0.3f, 0.0f}));
}

TEST_CASE("next ray: the same holds for someone below") {
  const Surface floor = bumped_floor(false);
  CHECK(next_towards(floor, -up, {0.1f, -1.0f, 0.0f})->origin.y < 0.0f);
  CHECK(next_towards(floor, -up, {0.1f, 1.0f, 0.0f})->origin.y > 0.0f);
  CHECK_FALSE(next_towards(floor, -up, {-1.0f, 0.1f, 0.0f}));
  CHECK_FALSE(next_towards(floor, -up, {1.0f, -0.3f, 0.0f}));
}

TEST_CASE("next ray: no reflection off any bump ever enters the floor") {
  Pcg32 random(6);
  int refused = 0;
  for (int i = 0; i < 100'000; ++i) {
    Surface floor = bumped_floor();
    floor.frame = frame_around(uniform_hemisphere(random.next_vec2()));
    floor.point.normal = vec3(0, 0, 1);
    const vec3 wi = uniform_hemisphere(random.next_vec2());
    const auto next = next_ray(floor, vec3(0, 0, 1), wi);
    refused += next ? 0 : 1;
    if (next) REQUIRE(next->direction.z > 0.0f);
  }
  // Two hemispheres with their axes at the angle theta share all but theta / pi. The axis is
  // uniform over the hemisphere: E[theta] = 1, the integral of theta sin(theta) over 0 to pi/2.
  CHECK(refused / 100'000.0 == Approx(1 / std::numbers::pi).margin(0.01));
}
