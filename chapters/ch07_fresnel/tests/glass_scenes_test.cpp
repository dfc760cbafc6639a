// Glass under an even sky, in closed form. A ball and a slab have one thing in common: a ray meets
// every surface at the same angle, so that F is the same each time. Of the light that a camera
// outside sees, F comes after one event, (1 - F)^2 F^j after 2 + j: after at most K events it is
//   F + (1 - F)^2 (1 + F + ... + F^(K-2)) = 1 - (1 - F) F^(K-1).
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "ch07_fresnel/smooth.hpp"
#include "ch07_fresnel/special_angles.hpp"
#include "ch07_fresnel/tests/oracles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const Material glass{.ior = 1.5f, .attenuation = Rgb(0.0f)};

UnderSky under_sky(const Scene& shapes) {
  UnderSky open{TexturedScene(shapes), Rgb(1.0f)};
  for (Look& look : open.scene.looks)
    look.material = glass;
  return open;
}

// A ball of 1 m around the origin; a slab from y = -1 to y = 1, so wide that no ray leaves at its
// sides.
UnderSky ball() {
  return under_sky({{{vec3(0.0f), 1.0f}}, {}, {}});
}
UnderSky slab() {
  Scene shapes;
  add_wall(shapes, {-500.0f, 1.0f, 500.0f}, {1000.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1000.0f});
  add_wall(shapes, {-500.0f, -1.0f, -500.0f}, {1000.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1000.0f});
  return under_sky(shapes);
}

// Rays that meet the ball or the slab at an angle whose sine is given.
Ray towards_ball(float sine) {
  return {{sine, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
}
Ray towards_slab(float sine) {
  return {{0.123f, 2.0f, 0.0f}, {sine, -std::sqrt(1.0f - sine * sine), 0.0f}};
}

RunningMean estimates(const UnderSky& open, const Ray& ray, int depth, int count) {
  return many(ray, count, [&](const Ray& r, Pcg32& random) {
    return radiance_recursive(open, smooth_bsdf_at, r, depth, random);
  });
}

double reflected_share(double sine, double here, double beyond) {
  return fresnel_dielectric(std::sqrt(1 - sine * sine), here, beyond);
}

void check_from_outside(const UnderSky& open, const std::function<Ray(float)>& towards) {
  for (const float sine : {0.1f, 0.5f, 0.9f, 0.99f})
    for (const int depth : {1, 2, 3, 4}) {
      const double f = reflected_share(sine, 1.0, 1.5);
      const double expected = 1 - (1 - f) * std::pow(f, depth - 1);
      CAPTURE(sine, depth, expected);
      CHECK(z_test(estimates(open, towards(sine), depth, 50'000), expected).agrees());
    }
}

}  // namespace

TEST_CASE("glass ball: under an even sky it shows the closed form at every depth") {
  check_from_outside(ball(), towards_ball);
}

TEST_CASE("glass slab: under an even sky it shows the closed form at every depth") {
  check_from_outside(slab(), towards_slab);
}

TEST_CASE("glass: lossless, it is as bright as the sky and not to be seen at all") {
  // At depth 200 less than 0.6^199 is left out, even at the ball's edge: each path gives 1.
  for (const float sine : {0.0f, 0.1f, 0.5f, 0.7f, 0.9f, 0.99f, -0.3f}) {
    for (const RunningMean& mean : {estimates(ball(), towards_ball(sine), 200, 20'000),
                                    estimates(slab(), towards_slab(sine), 200, 20'000)}) {
      CAPTURE(sine, mean.mean(), mean.standard_error());
      CHECK(mean.mean() == close_to(1.0, 1e-5));  // no chance is left, only rounding
    }
  }
}

TEST_CASE("glass: from inside it is brighter by the index squared, or dark for ever") {
  // One crossing: n^2 (1 - F) (1 + F + ... + F^(K-1)) = n^2 (1 - F^K); beyond the critical angle
  // nothing ever comes in.
  for (const float sine : {0.1f, 0.3f, 0.6f, 0.66f, 0.68f, 0.9f})
    for (const int depth : {1, 2, 5}) {
      const Ray in_ball{{sine, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
      const Ray in_slab{vec3(0.0f), {sine, std::sqrt(1.0f - sine * sine), 0.0f}};
      const double f = sine > 2.0 / 3 ? 1 : reflected_share(sine, 1.5, 1.0);
      const double expected = 2.25 * (1 - std::pow(f, depth));
      CAPTURE(sine, depth, expected);
      CHECK(z_test(estimates(ball(), in_ball, depth, 50'000), expected).agrees(1e-5));
      CHECK(z_test(estimates(slab(), in_slab, depth, 50'000), expected).agrees(1e-5));
    }
}

TEST_CASE("glass: over the directions inside, the mean is that of the sky outside") {
  // A point in glass gets light from a cone only, but n^2 as much: 2.25 times the share of
  // cosine-weighted directions in the cone, sin^2 < 1 / 2.25, makes 1. Half of all directions,
  // sin^2 < 1/2, hold the cone: over them the mean is 2. (Flatter rays would leave at the sides.)
  RunningMean mean;
  const UnderSky open = slab();
  for (int i = 0; i < 200'000; ++i) {
    Pcg32 random = stream_for(1, 0, 0, i);
    const vec2 u = random.next_vec2() * vec2(0.5f, 2.0f * pi);
    const float sine = std::sqrt(u.x);
    const vec3 up(sine * std::cos(u.y), std::sqrt(1.0f - u.x), sine * std::sin(u.y));
    mean.add(radiance_recursive(open, smooth_bsdf_at, {vec3(0.0f), up}, 60, random).g);
  }
  CAPTURE(mean.mean());
  CHECK(z_test(mean, 2.0).agrees());
}

TEST_CASE("mirror ball: under an even sky it shows what Fresnel's equations say") {
  UnderSky open = ball();
  open.scene.looks[0].material = {.ior = 0.277f, .extinction = 2.92f, .type = MaterialType::metal};
  for (const float sine : {0.0f, 0.5f, 0.9f}) {
    const double expected = complex_reflectance(std::sqrt(1.0 - sine * sine), {0.277, 2.92}).mean();
    CHECK(estimates(open, towards_ball(sine), 1, 10).mean() == close_to(expected, 1e-6));
  }
}
