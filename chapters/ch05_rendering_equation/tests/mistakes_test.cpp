// What each mistake does, in numbers; and which test would not have seen it.
#include "ch05_rendering_equation/mistakes.hpp"

#include <cmath>
#include <numbers>

#include "ch05_rendering_equation/furnace.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

constexpr double pi_exactly = std::numbers::pi;
const Ray towards_ball{{0.3f, 0.2f, -3.0f}, {0.0f, 0.0f, 1.0f}};

// A ball of albedo 0.5 under a sky of 1: it shows 0.5.
UnderSky ball_under_sky() {
  UnderSky open{TexturedScene(Scene{{{vec3(0.0f), 1.0f}}, {}, {}}), Rgb(1.0f)};
  open.scene.looks[0].material = matt(Rgb(0.5f));
  return open;
}

}  // namespace

TEST_CASE("mistakes: without the cosine a matt ball is twice as bright") {
  // The mean of 1 over the hemisphere instead of that of cos(theta), 1/2.
  const UnderSky open = ball_under_sky();
  const auto estimate = [&](const Ray& ray, Pcg32& random) {
    return radiance_recursive(open, mistakes::without_cosine_at, ray, 1, random);
  };
  CHECK(many(towards_ball, 1000, estimate).mean() == Approx(2 * 0.5).epsilon(1e-5));
}

TEST_CASE("mistakes: without pi a matt ball is pi times as bright") {
  const UnderSky open = ball_under_sky();
  const auto estimate = [&](const Ray& ray, Pcg32& random) {
    return radiance_recursive(open, mistakes::without_pi_at, ray, 1, random);
  };
  CHECK(z_test(many(towards_ball, 100'000, estimate), pi_exactly * 0.5).agrees());
}

TEST_CASE("mistakes: without the offset a ball shades itself") {
  const UnderSky open = ball_under_sky();
  const mistakes::WithoutOffset<UnderSky> wrong{open};
  RunningMean mean;
  for (int i = 0; i < 20'000; ++i) {
    Pcg32 random = stream_for(1, 0, 0, i);
    const vec2 shift = 0.5f * random.next_vec2();
    const Ray ray{{shift, -3.0f}, {0.0f, 0.0f, 1.0f}};
    mean.add(radiance_recursive(wrong, uniform_lambert_at, ray, 1, random).g);
  }
  const ZTest test = z_test(mean, 0.5);
  CAPTURE(mean.mean());
  CHECK(test.z < -30);
  CHECK(test.effect < -0.05);
}

TEST_CASE("mistakes: a furnace does not see that the offset is missing") {
  // Every place in it is as bright as every other: it does not matter which one a path hits.
  const TexturedScene box = closed_box(matt(Rgb(0.5f), Rgb(1.0f)));
  const mistakes::WithoutOffset<TexturedScene> wrong{box};
  const Ray ray{{1.0f, 1.4f, 2.0f}, normalize(vec3(-0.3f, 0.5f, -0.8f))};
  for (int depth = 0; depth <= 3; ++depth)
    CHECK(
        z_test(many(ray, 20'000, uniform_estimator(wrong, depth)), furnace_radiance(1, 0.5, depth))
            .agrees());
}

TEST_CASE("mistakes: to end in black is to stop one event too early") {
  // 0, 1, 1 + 1/2, ... where 1, 1 + 1/2, 1 + 1/2 + 1/4, ... is right.
  const TwoPlates plates{matt(Rgb(0.5f), Rgb(1.0f)), matt(Rgb(0.5f), Rgb(1.0f))};
  const Ray up{{0.0f, 0.5f, 0.0f}, {0.0f, 1.0f, 0.0f}};
  Pcg32 random(1);
  for (int depth = 0; depth <= 8; ++depth) {
    const float sum = 2.0f - std::ldexp(2.0f, -depth);
    CHECK(mistakes::radiance_black_end(plates, straight_up_at, up, depth, random) == Rgb(sum));
    CHECK(radiance_recursive(plates, straight_up_at, up, depth, random) == Rgb(1.0f + sum / 2.0f));
  }
}
