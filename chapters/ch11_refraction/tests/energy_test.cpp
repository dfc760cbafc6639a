// How much light a rough glass surface lets go anywhere, in and out.
#include "ch11_refraction/interface_energy.hpp"
#include "ch11_refraction/tests/glasses.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

TEST_CASE("glass energy: never more comes out than went in: 9 angles, 5 widths, both sides") {
  over_both_sides([](const auto& glass, vec3 wo) {
    const RunningMean mean = energy_of(glass, wo, 20'000);
    CAPTURE(glass.ggx.alpha, glass.n_here, wo.z, mean.mean());
    CHECK(mean.mean() <= 1 + 6 * mean.standard_error());
    CHECK(interface_energy(glass, wo.z, 60).total() <= 1 + 1e-6);
  });
}

TEST_CASE("glass energy: into index 1.5 at alpha 0.1 it is what the published errata say") {
  // With the separable form for reflections, too.
  const RoughGlass<VisibleNormals, g2_separable> glass{{0.1f}, 1.0f, 1.5f};
  const std::pair<float, double> rows[] = {
      {1.0f, 0.9988}, {0.5f, 0.9922}, {0.3f, 0.9751}, {0.1f, 0.9157}};
  for (const auto& [mu, expected] : rows)
    CHECK(interface_energy(glass, mu, 1000).total() == close_to(expected, 1.5e-4));
}

TEST_CASE("glass energy: straight on, 0.959198 goes through index 1.5, 0.999490 through 1.04") {
  CHECK(interface_energy(into(0.1f), 1.0f, 1000).through == close_to(0.959198, 1e-4));
  CHECK(interface_energy(into(0.1f, 1.04f), 1.0f, 1000).through == close_to(0.999490, 1e-4));
}

TEST_CASE(
    "glass energy: the smoother the surface, the less is lost, and nothing if it is polished") {
  for (const bool outside : {true, false})
    for (const float mu : {1.0f, 0.8f, 0.5f, 0.3f}) {
      const auto total = [&](float alpha) {
        return interface_energy(outside ? into(alpha) : out_of(alpha), mu, 100).total();
      };
      CAPTURE(outside, mu);
      CHECK(total(1e-3f) == close_to(1.0, 2e-3));
      CHECK(total(1e-3f) >= total(0.05f) - 1e-3);
      CHECK(total(0.3f) > total(1.0f));
    }
}

TEST_CASE("glass energy: smooth, the shares are Fresnel's") {
  for (const float mu : {1.0f, 0.8f, 0.5f, 0.3f}) {
    const double in = fresnel_dielectric(double{mu}, 1.0, 1.5);
    const double out = fresnel_dielectric(double{mu}, 1.5, 1.0);
    CHECK(interface_energy(into(1e-3f), mu, 100).reflected == close_to(in, 1e-3));
    CHECK(interface_energy(out_of(1e-3f), mu, 100).reflected == close_to(out, 2e-3));
  }
}

TEST_CASE("glass energy: samples give the same as the quadrature over directions") {
  // Radiance from an even sky beyond: the integral of f |cos| over the whole sphere.
  for (const auto& glass : {into(0.3f), out_of(0.3f), into(1.0f), out_of(1.0f)})
    for (const float mu : {0.9f, 0.3f}) {
      const vec3 wo = slanting_at(mu);
      const double expected = integrate_directions(
          [&](vec3 wi) { return double{glass.eval(wo, wi).g * std::abs(wi.z)}; }, 1e-5);
      Pcg32 random(2);
      RunningMean mean;
      for (int i = 0; i < 200'000; ++i) {
        const auto sample = glass.sample(wo, random.next_vec3());
        mean.add(sample ? double{sample->weight.g} : 0.0);
      }
      CAPTURE(glass.ggx.alpha, glass.n_here, mu, expected, mean.mean());
      CHECK(z_test(mean, expected).agrees(1e-3));
    }
}

TEST_CASE("glass energy: from everywhere, n^2 times as much gets in as out") {
  // Reciprocity, integrated over both hemispheres: T(in) = 2.25 T(out), each the mean over
  // cosine-weighted directions.
  for (const float alpha : {0.1f, 0.3f, 1.0f}) {
    const auto mean = [](const RoughGlass<>& glass) {
      double sum = 0;
      const int steps = 200;
      for (int i = 0; i < steps; ++i) {
        const float squared = (static_cast<float>(i) + 0.5f) / steps;
        sum += interface_energy(glass, std::sqrt(squared), 100).through;
      }
      return sum / steps;
    };
    CHECK(mean(into(alpha)) / mean(out_of(alpha)) == close_to(2.25, 2e-3));
  }
}
