#include "ch05_rendering_equation/radiance.hpp"

#include "ch05_rendering_equation/furnace.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const Ray from_inside{{0.1f, 0.2f, -0.3f}, normalize(vec3(0.5f, 0.7f, -0.2f))};

// Right, and measured well enough for that to mean something.
void check_mean(const RunningMean& measured, double expected, double largest_error = 0.01) {
  CAPTURE(measured.mean(), measured.standard_error(), expected);
  CHECK(z_test(measured, expected).agrees());
  CHECK(measured.standard_error() < largest_error * expected);
}

}  // namespace

TEST_CASE("radiance: without noise the recursion adds one power of the albedo with each event") {
  // 1, 1 + 1/2, 1 + 1/2 + 1/4, ...: exact in binary.
  const TwoPlates plates{matt(Rgb(0.5f), Rgb(1.0f)), matt(Rgb(0.5f), Rgb(1.0f))};
  Pcg32 random(1);
  for (int depth = 0; depth <= 8; ++depth) {
    const Ray up{{0.0f, 0.5f, 0.0f}, {0.0f, 1.0f, 0.0f}};
    CHECK(radiance_recursive(plates, straight_up_at, up, depth, random) ==
          Rgb(2.0f - std::ldexp(1.0f, -depth)));
  }
}

TEST_CASE("radiance: two colours are multiplied in the order in which the path meets them") {
  // Seen from below: E + B (e + a (E + B e)), E and B above, e and a below; powers of two.
  const Rgb e(1.0f, 2.0f, 0.0f), a(0.5f, 0.25f, 1.0f);
  const Rgb E(4.0f, 0.0f, 8.0f), B(0.25f, 0.5f, 0.125f);
  const TwoPlates plates{matt(a, e), matt(B, E)};
  const Ray up{{0.0f, 0.5f, 0.0f}, {0.0f, 1.0f, 0.0f}};
  const Rgb expected[] = {E, E + B * e, E + B * (e + a * E), E + B * (e + a * (E + B * e))};
  Pcg32 random(1);
  for (int depth = 0; depth <= 3; ++depth)
    CHECK(radiance_recursive(plates, straight_up_at, up, depth, random) == expected[depth]);

  for (int channel = 0; channel < 3; ++channel)  // and with noise
    check_mean(many(up, 200'000, uniform_estimator(plates, 3), channel), expected[3][channel]);
}

TEST_CASE("radiance: a hollow sphere is a furnace at depths 0 to 8") {
  for (const float albedo : {0.2f, 0.5f, 0.8f, 1.0f}) {
    const HollowSphere furnace{matt(Rgb(albedo), Rgb(3.0f))};
    for (int depth = 0; depth <= 8; ++depth) {
      CAPTURE(albedo, depth);
      check_mean(many(from_inside, 20'000, uniform_estimator(furnace, depth)),
                 furnace_radiance(3, albedo, depth), 0.02);
    }
  }
}

TEST_CASE("radiance: a box of triangles is a furnace at depths 0 to 8") {
  const TexturedScene box = closed_box(matt(Rgb(0.7f), Rgb(1.0f)));
  const Ray ray{{1.0f, 1.4f, 2.0f}, normalize(vec3(-0.3f, 0.5f, -0.8f))};
  for (int depth = 0; depth <= 8; ++depth)
    check_mean(many(ray, 20'000, uniform_estimator(box, depth)), furnace_radiance(1, 0.7, depth));
}

TEST_CASE("radiance: a lamp in the middle of a matt shell lights it evenly") {
  // The lamp fills s = (r/R)^2 of what any point of the shell sees, weighted by the cosine; the
  // rest is shell: rho L s (1 + q + q^2 + ...), q = rho (1 - s), one term for each event.
  const double s = 0.16, rho = 0.7, radiance = 5;
  const TexturedScene scene = shell(0.8f, 0.7f, 5.0f);
  const Ray outward{{0.0f, 1.2f, 0.3f}, normalize(vec3(0.2f, 1.0f, 0.1f))};
  CHECK(many(outward, 10, uniform_estimator(scene, 0)).mean() == 0);
  double expected = 0;
  for (int depth = 1; depth <= 5; ++depth) {
    expected += rho * radiance * s * std::pow(rho * (1 - s), depth - 1);
    check_mean(many(outward, 200'000, uniform_estimator(scene, depth)), expected);
  }
}

TEST_CASE("radiance: a floor under a sphere light obeys the inverse square and the cosine") {
  // rho L (R/d)^2 cos(theta): distance 2.5 m, cosine 2 / 2.5.
  TexturedScene scene(Scene{{{{1.5f, 2.0f, 0.0f}, 0.5f}}, {}, {{0.0f}}});
  scene.looks[0].material = matt(Rgb(0.0f), Rgb(10.0f));
  scene.looks[1].material = matt(Rgb(0.6f));
  const vec3 eye(-1.0f, 1.0f, 0.2f);
  check_mean(many({eye, normalize(-eye)}, 400'000, uniform_estimator(scene, 1)),
             0.6 * 10 * 0.04 * 0.8, 0.02);
}

TEST_CASE("radiance: a convex object under an even sky shows its albedo times the sky") {
  UnderSky open{TexturedScene(Scene{{{vec3(0.0f), 1.0f}}, {}, {}}), {1.0f, 2.0f, 0.5f}};
  open.scene.looks[0].material = matt({0.6f, 0.3f, 0.9f});
  for (const int depth : {1, 5})
    for (const float offset : {0.0f, 0.7f, 0.99f})  // from the middle to the edge
      for (int channel = 0; channel < 3; ++channel) {
        const Ray ray{{offset, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
        const double expected = open.scene.looks[0].material.tint[channel] * open.sky[channel];
        check_mean(many(ray, 20'000, uniform_estimator(open, depth), channel), expected, 0.02);
      }
  Pcg32 random(1);
  const Ray past{{2.0f, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
  CHECK(uniform_estimator(open, 5)(past, random) == open.sky);
}

TEST_CASE("radiance: a lamp shines from its outer side only") {
  TexturedScene scene(Scene{{{vec3(0.0f), 1.0f}}, {}, {}});
  scene.looks[0].material = matt(Rgb(0.5f), Rgb(4.0f));
  Pcg32 random(1);
  const Ray outside{{0.0f, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
  CHECK(uniform_estimator(scene, 0)(outside, random) == Rgb(4.0f));
  for (int depth = 0; depth <= 3; ++depth)
    CHECK(uniform_estimator(scene, depth)(from_inside, random) == Rgb(0.0f));
}

TEST_CASE("radiance: where no direction is proposed only the surface's own light is left") {
  const TwoPlates plates{matt(Rgb(0.5f), Rgb(1.0f)), matt(Rgb(0.5f), Rgb(2.0f))};
  Pcg32 random(1);
  CHECK(radiance_recursive(plates, soot_at, {{0.0f, 0.5f, 0.0f}, {0.0f, 1.0f, 0.0f}}, 5, random) ==
        Rgb(2.0f));
}
