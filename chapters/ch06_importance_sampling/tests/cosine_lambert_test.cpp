#include "ch06_importance_sampling/cosine_lambert.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch05_rendering_equation/furnace.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/exercise.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const CosineLambert chalk{{0.5f, 0.8f, 0.2f}};
const vec3 slanting = normalize(vec3(0.6f, -0.3f, 0.4f));

template <Traceable AnyScene>
auto cosine_estimator(const AnyScene& scene, int depth) {
  return [&scene, depth](const Ray& ray, Pcg32& random) {
    return radiance_recursive(scene, cosine_lambert_at, ray, depth, random);
  };
}

}  // namespace

TEST_CASE("cosine lambert: sample and eval and pdf belong together") {
  Pcg32 random(1);
  for (const vec3 wo : {vec3(0, 0, 1), slanting, normalize(vec3(1, 0, 0.01f))}) {
    CHECK(triple_complaint(chalk, wo, 100'000, random, 1e-5) == "");
    CHECK(triple_complaint(UniformLambert{chalk.albedo}, wo, 100'000, random, 1e-5) == "");
  }
}

TEST_CASE("cosine lambert: chi-square of both samplers of a matt surface") {
  Pcg32 random(2);
  const auto complaint = [&](const auto& bsdf) {
    return test_sampler(
               [&] { return std::optional(bsdf.sample(slanting, random.next_vec3())->wi); },
               [&](vec3 wi) { return bsdf.pdf(slanting, wi); })
        .complaint;
  };
  CHECK(complaint(chalk) == "");
  CHECK(complaint(UniformLambert{chalk.albedo}) == "");
}

TEST_CASE("cosine lambert: it is the same surface as the uniform one, and gives back its albedo") {
  TestRandom random(3);
  for (int i = 0; i < 1000; ++i) {
    const vec3 wo = random.direction();
    const vec3 wi = random.direction();
    REQUIRE(chalk.eval(wo, wi) == UniformLambert{chalk.albedo}.eval(wo, wi));
  }
  for (int c = 0; c < 3; ++c)
    CHECK(integrate_directions([&](vec3 wi) {
            return double{chalk.eval(slanting, wi)[c]} * std::abs(wi.z);
          }) == Approx(chalk.albedo[c]).epsilon(1e-5));
}

TEST_CASE("cosine lambert: every weight is the albedo") {
  Pcg32 random(4);
  for (int i = 0; i < 1000; ++i)
    REQUIRE(chalk.sample(slanting, random.next_vec3())->weight == chalk.albedo);
}

TEST_CASE("cosine lambert: in a furnace every single path brings the same, with no variance") {
  // Le (1 + a + a^2 + ... + a^depth), with a and the sums exact in binary.
  const HollowSphere furnace{matt(Rgb(0.5f), Rgb(1.0f))};
  const TexturedScene box = closed_box(matt(Rgb(0.5f), Rgb(1.0f)));
  const Ray in_sphere{{0.1f, 0.2f, -0.3f}, normalize(vec3(0.5f, 0.7f, -0.2f))};
  const Ray in_box{{1.0f, 1.4f, 2.0f}, normalize(vec3(-0.3f, 0.5f, -0.8f))};
  for (int depth = 0; depth <= 8; ++depth) {
    const RunningMean sphere = many(in_sphere, 2000, cosine_estimator(furnace, depth));
    const RunningMean walls = many(in_box, 2000, cosine_estimator(box, depth));
    CAPTURE(depth);
    CHECK(sphere.variance() == 0);
    CHECK(walls.variance() == 0);
    CHECK(sphere.mean() == furnace_radiance(1, 0.5, depth));
    CHECK(walls.mean() == furnace_radiance(1, 0.5, depth));
    // The uniform sampler is right in the mean only.
    if (depth > 0)
      CHECK(many(in_sphere, 2000, uniform_estimator(furnace, depth)).variance() > 0.05);
  }
}

TEST_CASE("cosine lambert: a matt object under an even sky has no noise") {
  UnderSky open{TexturedScene(Scene{{{vec3(0.0f), 1.0f}}, {}, {}}), {1.0f, 2.0f, 0.5f}};
  open.scene.looks[0].material = matt({0.5f, 0.25f, 0.75f});
  Pcg32 random(5);
  for (int i = 0; i < 1000; ++i)
    REQUIRE(cosine_estimator(open, 3)({{0.7f, 0.0f, -3.0f}, {0, 0, 1}}, random) ==
            Rgb(0.5f, 0.5f, 0.375f));
}

TEST_CASE("cosine lambert: a lamp in a matt shell lights it by the closed form") {
  // The lamp fills s = (r/R)^2 of what a point of the shell sees, weighted by the cosine.
  const double s = 0.16, rho = 0.7, radiance = 5;
  const TexturedScene scene = shell(0.8f, 0.7f, 5.0f);
  const Ray outward{{0.0f, 1.2f, 0.3f}, normalize(vec3(0.2f, 1.0f, 0.1f))};
  double expected = 0;
  for (int depth = 1; depth <= 5; ++depth) {
    expected += rho * radiance * s * std::pow(rho * (1 - s), depth - 1);
    const RunningMean measured = many(outward, 200'000, cosine_estimator(scene, depth));
    CHECK(z_test(measured, expected).agrees());
    CHECK(measured.standard_error() < 0.006 * expected);
    if (depth > 1) continue;
    // One event hits the lamp with probability s: the variance is that of a coin, times (rho L)^2.
    CHECK(measured.variance() == Approx(std::pow(rho * radiance, 2) * s * (1 - s)).epsilon(0.02));
  }
}
