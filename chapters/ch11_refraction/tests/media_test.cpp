// Coloured glass, in closed form. A ball and a slab have one thing in common: a ray meets every
// surface at the same angle, and all its ways through the glass have the same length x. With
// t = exp(-attenuation x), F is reflected outside, and (1 - F)^2 t (1 + F t + (F t)^2 + ...) comes
// through.
#include "ch11_refraction/media.hpp"

#include "ch05_rendering_equation/tests/scenes.hpp"
#include "ch11_refraction/complete.hpp"
#include "ch11_refraction/glass_scenes.hpp"
#include "ch11_refraction/tests/glasses.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const Rgb attenuation(0.0f, 1.0f, 0.666f);  // the thesis' clear sphere

const Material coloured{.roughness = 0.0f, .ior = 1.5f, .attenuation = attenuation};

UnderSky under_sky(const Scene& shapes, const Material& material) {
  UnderSky open{TexturedScene(shapes), Rgb(1.0f)};
  for (Look& look : open.scene.looks)
    look.material = material;
  return open;
}

// A ball of 0.7 m; a slab from y = -0.3 to y = 0.3, so wide that no ray leaves at its sides.
UnderSky ball(const Material& material) {
  return under_sky({{{vec3(0.0f), 0.7f}}, {}, {}}, material);
}
UnderSky slab(const Material& material) {
  Scene shapes;
  add_wall(shapes, {-500.0f, 0.3f, 500.0f}, {1000.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1000.0f});
  add_wall(shapes, {-500.0f, -0.3f, -500.0f}, {1000.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1000.0f});
  return under_sky(shapes, material);
}

// Rays that meet the ball or the slab at an angle whose sine is given.
Ray towards_ball(float sine) {
  return {{0.7f * sine, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
}
Ray towards_slab(float sine) {
  return {{0.123f, 2.0f, 0.0f}, {sine, -std::sqrt(1.0f - sine * sine), 0.0f}};
}

template <Traceable AnyScene>
RunningMean estimates(const AnyScene& scene, const Ray& ray, int depth, int count, int channel) {
  const auto estimate = [&](const Ray& r, Pcg32& random) {
    return radiance_through_media(
        scene, [](const Surface& s) { return complete_bsdf_at(s); }, r, depth, random);
  };
  return many(ray, count, estimate, channel);
}

double closed_form(double sine, double straight_way, double sigma) {
  const double f = fresnel_dielectric(std::sqrt(1 - sine * sine), 1.0, 1.5);
  const double t = std::exp(-sigma * straight_way);
  return f + (1 - f) * (1 - f) * t / (1 - f * t);
}

// Share that is mirrored, by an integral over facets: those that wo sees, in proportion to
// D (wo h) G2 / mu_o, each mirrors F of the light.
double mirrored_share(double alpha, double mu) {
  const double sine = std::sqrt(1 - mu * mu);
  return integrate_facets(alpha, 400, [=](vec3 h) {
    const double wo_h = sine * h.x + mu * h.z;
    const double mu_i = 2 * wo_h * h.z - mu;
    if (wo_h <= 0 || mu_i <= 0) return 0.0;
    const double d = d_by_angle(alpha, std::acos(std::min(1.0, double{h.z})));
    const double f = complex_reflectance(wo_h, 1.5).mean();
    return f * d * wo_h * g2_by_cosines(alpha, mu, mu_i) / mu;
  });
}

}  // namespace

TEST_CASE("transmittance: two ways one after the other multiply, and so do two colours' worth") {
  const Rgb one = transmittance(attenuation, 0.3f), two = transmittance(attenuation, 0.5f);
  CHECK(transmittance(attenuation, 0.8f) == close_to(one * two, 1e-6));
  CHECK(transmittance(2.0f * attenuation, 0.3f) == close_to(one * one, 1e-6));
  // A millionth of a metre takes a millionth of the attenuation away.
  CHECK(1.0f - transmittance(Rgb(1.0f), 1e-3f).g == close_to(1e-3, 1e-6));
}

TEST_CASE("transmittance: only who meets a clear object from inside has come through it") {
  Surface surface{};
  surface.material = coloured;
  surface.outside = false;
  CHECK(transmittance_to(surface, 0.5f) == transmittance(attenuation, 0.5f));
  surface.outside = true;
  CHECK(transmittance_to(surface, 0.5f) == Rgb(1.0f));
  surface.outside = false;
  surface.material.attenuation = Rgb(500.0f);  // a thin wall from behind
  CHECK(transmittance_to(surface, 0.5f) == Rgb(1.0f));
}

TEST_CASE("absorbing ball: under an even sky it shows the closed form, in each colour") {
  const UnderSky open = ball(coloured);
  for (const float sine : {0.0f, 0.5f, 0.9f})
    for (const int channel : {0, 1, 2}) {
      const double cos_beyond = std::sqrt(1 - sine * sine / 2.25);
      const double expected = closed_form(sine, 2 * 0.7 * cos_beyond, double{attenuation[channel]});
      CAPTURE(sine, channel, expected);
      CHECK(z_test(estimates(open, towards_ball(sine), 100, 100'000, channel), expected)
                .agrees(1e-4));
    }
}

TEST_CASE("absorbing slab: its ways are as long as it is thick, over the cosine inside") {
  const UnderSky open = slab(coloured);
  for (const float sine : {0.1f, 0.707f, 0.95f})
    for (const int channel : {0, 1}) {
      const double cos_beyond = std::sqrt(1 - sine * sine / 2.25);
      const double expected = closed_form(sine, 0.6 / cos_beyond, double{attenuation[channel]});
      CAPTURE(sine, channel, expected);
      CHECK(z_test(estimates(open, towards_slab(sine), 100, 100'000, channel), expected)
                .agrees(1e-4));
    }
}

TEST_CASE("clear ball and slab: what loses nothing cannot be seen under an even sky") {
  Material clear = coloured;
  clear.attenuation = Rgb(0.0f);
  for (const float sine : {0.0f, 0.5f, 0.9f, 0.99f}) {
    CHECK(estimates(ball(clear), towards_ball(sine), 300, 2'000, 1).mean() == close_to(1.0, 1e-5));
    CHECK(estimates(slab(clear), towards_slab(sine), 300, 2'000, 1).mean() == close_to(1.0, 1e-5));
  }
}

TEST_CASE("index-matched ball: a parallel beam loses (1 - (1 + 2 s R) e^(-2 s R)) / (2 s^2 R^2)") {
  // No bending, no reflection: chords of length 2 R cos, over the disk that faces the beam.
  Material smoke = coloured;
  smoke.ior = 1.0f;
  for (const float roughness : {0.0f, 0.5f}) {  // there is nothing for facets to bend at
    smoke.roughness = roughness;
    const UnderSky open = ball(smoke);
    RunningMean mean;
    Pcg32 random(1);
    for (int i = 0; i < 100'000; ++i) {
      const Ray ray{{0.7f * uniform_disk(random.next_vec2()), -3.0f}, {0.0f, 0.0f, 1.0f}};
      mean.add(radiance_through_media(
                   open, [](const Surface& s) { return complete_bsdf_at(s); }, ray, 4, random)
                   .g);
    }
    const double x = 2 * 0.7 * 1.0;
    CHECK(z_test(mean, 2 * (1 - (1 + x) * std::exp(-x)) / (x * x)).agrees(1e-3));
  }
}

TEST_CASE("coloured glass: how far away the camera is does not count") {
  const UnderSky open = ball(coloured);
  const Ray near{{0.2f, 0.0f, -1.0f}, {0, 0, 1}}, far{{0.2f, 0.0f, -50.0f}, {0, 0, 1}};
  CHECK(estimates(open, near, 20, 50'000, 1).mean() ==
        Approx(estimates(open, far, 20, 50'000, 1).mean()).epsilon(1e-4));
}

TEST_CASE("coloured glass: a camera inside is in it from the start") {
  // From the centre every way is a radius long and straight on: 2.25 (1 - F) t (1 + F t^2 + ...).
  const UnderSky open = ball(coloured);
  for (const int channel : {0, 1}) {
    const double t = std::exp(-0.7 * double{attenuation[channel]});
    const double expected = 2.25 * 0.96 * t / (1 - 0.04 * t * t);
    const Ray ray{vec3(0.0f), {0, 0, 1}};
    CHECK(z_test(estimates(open, ray, 100, 100'000, channel), expected).agrees(1e-4));
  }
}

TEST_CASE("lamp in glass: it is seen at (1 - F) / n^2 of its radiance, polished or nearly so") {
  // Straight on F = 0.04: 0.5 * 0.96 / 2.25, and 0.04 of the sky's 0.03 are mirrored.
  for (const float roughness : {0.0f, 0.002f}) {
    Studio studio = lamp_in_glass(1.5f);
    studio.scene.looks[0].material.roughness = roughness;
    const Ray ray{{-1.2f, 0.0f, -9.0f}, {0, 0, 1}};
    const double expected = 0.5 * 0.96 / 2.25 + 0.04 * 0.03;
    CHECK(z_test(estimates(studio, ray, 20, 200'000, 1), expected).agrees(1e-4));
  }
}

TEST_CASE("lamp in glass: it looks n times as large") {
  // A ray that misses the lamp by what it would without glass: at 1.4 radii it is still seen.
  const Studio studio = lamp_in_glass(1.5f);
  const auto at = [&](float x) {
    return estimates(studio, {{-1.2f + x, 0.0f, -9.0f}, {0, 0, 1}}, 20, 2'000, 1).mean();
  };
  CHECK(at(0.35f * 1.45f) > 0.15);
  CHECK(at(0.35f * 1.55f) < 0.05);
}

TEST_CASE("rough glass ball: after one event only what is mirrored is seen: its share") {
  for (const float alpha : {0.1f, 0.5f}) {
    const UnderSky open = ball({.roughness = alpha, .ior = 1.5f, .attenuation = Rgb(0.0f)});
    for (const float sine : {0.0f, 0.6f, 0.95f}) {
      const double expected = mirrored_share(alpha, std::sqrt(1.0 - double{sine} * double{sine}));
      CAPTURE(alpha, sine, expected);
      CHECK(z_test(estimates(open, towards_ball(sine), 1, 200'000, 1), expected).agrees(2e-3));
    }
  }
}

TEST_CASE("rough glass ball: ever smoother, it becomes invisible, but rough, it loses light") {
  const auto mean = [](float alpha) {
    const UnderSky open = ball({.roughness = alpha, .ior = 1.5f, .attenuation = Rgb(0.0f)});
    return estimates(open, towards_ball(0.3f), 60, 50'000, 1).mean();
  };
  CHECK(mean(0.001f) == close_to(1.0, 2e-3));
  CHECK(mean(0.1f) < 1.0);
  CHECK(mean(0.5f) < mean(0.1f));
}
