// What each mistake does, in numbers; and which test would not have seen it.
#include "ch07_fresnel/mistakes.hpp"

#include "ch05_rendering_equation/tests/scenes.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

constexpr float last = 1.0f - 0x1p-24f;

vec3 at_degrees(float degrees) {
  return {std::sin(radians(degrees)), 0.0f, std::cos(radians(degrees))};
}

UnderSky glass_ball() {
  UnderSky open{TexturedScene(Scene{{{vec3(0.0f), 1.0f}}, {}, {}}), Rgb(1.0f)};
  open.scene.looks[0].material = {.ior = 1.5f, .attenuation = Rgb(0.0f)};
  return open;
}

template <class GlassFrom>
RunningMean seen_with(const GlassFrom& glass_from, const Ray& ray, int depth = 64) {
  const UnderSky open = glass_ball();
  return many(ray, 20'000, [&](const Ray& r, Pcg32& random) {
    return radiance_recursive(open, mistakes::with_glass(glass_from), r, depth, random);
  });
}

const Ray towards_ball{{0.5f, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
const Ray from_inside{{0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};

Glass with_scale(const Surface& surface) {
  return glass_at(surface);
}
mistakes::GlassWithoutScale without_scale(const Surface& surface) {
  return {glass_at(surface)};
}
mistakes::GlassChosenAndWeighted weighted_twice(const Surface& surface) {
  return {glass_at(surface)};
}

}  // namespace

TEST_CASE("mistakes: sides exchanged, glass at 60 degrees reflects everything") {
  Surface surface{};
  surface.outside = true;
  surface.material.ior = 1.5f;
  const Glass wrong = mistakes::glass_inside_out_at(surface);
  CHECK(fresnel_dielectric(0.5f, wrong.n_here, wrong.n_beyond) == 1.0f);
  CHECK(fresnel_dielectric(0.5f, 1.0f, 1.5f) == close_to(0.0891867, 1e-6));
}

TEST_CASE("mistakes: sides exchanged, an even sky shows nothing wrong") {
  // An air bubble in glass loses no light either: only where one looks through it is it wrong.
  CHECK(seen_with(mistakes::glass_inside_out_at, towards_ball).mean() == close_to(1.0, 1e-4));
}

TEST_CASE("mistakes: the printed formula is no number beyond the critical angle") {
  // g^2 = 1/2.25 - 1 + 1/2 = -0.0556 at 45 degrees from inside 1.5.
  const float cosine = std::sqrt(0.5f);
  CHECK(std::isnan(mistakes::fresnel_without_total_reflection(cosine, 1.5f, 1.0f)));
  CHECK(fresnel_dielectric(cosine, 1.5f, 1.0f) == 1.0f);
  CHECK(mistakes::fresnel_without_total_reflection(0.9f, 1.5f, 1.0f) ==
        fresnel_dielectric(0.9f, 1.5f, 1.0f));
  const auto sample =
      mistakes::GlassWithoutTotalReflection{{1.5f, 1.0f}}.sample(at_degrees(45), vec3(0.5f));
  CHECK(std::isnan(sample->wi.z));
}

TEST_CASE("mistakes: without the scale a ball looks right from outside and too dark inside") {
  CHECK(seen_with(with_scale, towards_ball).mean() == close_to(1.0, 1e-5));
  CHECK(seen_with(without_scale, towards_ball).mean() == close_to(1.0, 1e-5));
  CHECK(seen_with(with_scale, from_inside).mean() == close_to(2.25, 1e-5));
  CHECK(seen_with(without_scale, from_inside).mean() == close_to(1.0, 1e-5));
}

TEST_CASE("mistakes: chosen and weighted, light is lost at every surface") {
  // Straight on: reflected F F, let through (1 - F) (1 - F), at one surface with F = 0.04. After at
  // most two events from outside: F^2 + (1 - F)^4.
  const Ray straight{{0.0f, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
  const double expected = 0.04 * 0.04 + std::pow(0.96, 4);
  CHECK(z_test(seen_with(weighted_twice, straight, 2), expected).agrees());
}

TEST_CASE("mistakes: the conductor as printed is a fifth too dark, and no dielectric") {
  // Columns "exact" and "printed", computed independently.
  struct Row {
    double degrees, eta, k, exact, printed;
  };
  const Row rows[] = {{0, 0.277, 2.92, 0.890914, 0.734889},  {45, 0.277, 2.92, 0.888388, 0.727169},
                      {80, 0.277, 2.92, 0.915278, 0.790708}, {0, 1.5, 0, 0.040000, 0.120784},
                      {45, 1.5, 0, 0.050240, 0.120000},      {80, 1.5, 0, 0.387704, 0.505874},
                      {0, 2.9, 3.1, 0.532635, 0.628550},     {45, 2.9, 3.1, 0.527235, 0.622098},
                      {80, 2.9, 3.1, 0.547352, 0.629422}};
  for (const auto& [degrees, eta, k, exact, printed] : rows) {
    const double c = std::cos(degrees * 3.14159265358979323846 / 180);
    CHECK(fresnel_conductor(c, 1.0, eta, k) == close_to(exact, 1e-6));
    CHECK(mistakes::fresnel_conductor_as_printed(c, 1.0, eta, k) == close_to(printed, 1e-6));
  }
  const mistakes::MirrorAsPrinted ball{{{Rgb(0.277f), Rgb(2.92f)}}};
  CHECK(ball.sample({0, 0, 1}, vec3(last))->weight == close_to(Rgb(0.734889f), 1e-5));
}
