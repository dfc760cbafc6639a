// How much light comes back of 1: the reason for this chapter.
#include "ch04_monte_carlo/pcg32.hpp"
#include "ch10_dielectric/tests/coats.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const Rgb white(1.0f);

template <class Coated>
RunningMean mean_weight(const Coated& bsdf, vec3 wo, int count) {
  Pcg32 random(3);
  RunningMean mean;
  for (int i = 0; i < count; ++i) {
    const auto sample = bsdf.sample(wo, random.next_vec3());
    mean.add(sample ? double{sample->weight.g} : 0.0);
  }
  return mean;
}

// Never above 1 beyond the noise.
template <class Coated>
void check_no_gain(const Coated& bsdf, vec3 wo) {
  const RunningMean mean = mean_weight(bsdf, wo, 10'000);
  CHECK(mean.mean() <= 1.0 + 6 * mean.standard_error());
}

}  // namespace

TEST_CASE("energy: thesis eq. 7 creates light, as much as its published errata say") {
  // White base, index 1.5, separable G, by quadrature; rows smooth, 0.05, 0.1, 0.3, 0.6 and 1.
  const float alphas[] = {0.0f, 0.05f, 0.1f, 0.3f, 0.6f, 1.0f};
  const float cosines[] = {1.0f, 0.8f, 0.5f, 0.3f, 0.2f, 0.1f, 0.02f};
  const double totals[6][7] = {{0.9594, 0.9588, 0.9924, 1.0982, 1.2209, 1.4436, 1.7539},
                               {0.9593, 0.9591, 0.9922, 1.0871, 1.1817, 1.2984, 1.3613},
                               {0.9590, 0.9592, 0.9891, 1.0605, 1.1176, 1.1779, 1.2160},
                               {0.9550, 0.9545, 0.9638, 0.9809, 0.9934, 1.0075, 1.0170},
                               {0.9437, 0.9420, 0.9399, 0.9398, 0.9404, 0.9415, 0.9425},
                               {0.9321, 0.9300, 0.9241, 0.9183, 0.9149, 0.9114, 0.9089}};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 7; ++j)
      CHECK(white_total("thesis", alphas[i], cosines[j], 200) == close_to(totals[i][j], 2e-4));
}

TEST_CASE("energy: the thesis' smooth coat crosses 1 at 61.7 degrees") {
  CHECK(white_total("thesis", 0.0f, at_degrees(61.5f).z, 200) < 1.0);
  CHECK(white_total("thesis", 0.0f, at_degrees(61.9f).z, 200) > 1.0);
}

TEST_CASE("energy: both repairs give back no more than came, for 9 angles and 5 widths") {
  over_grid([](float alpha, vec3 wo) {
    check_no_gain(coated(alpha, reciprocal_base(white)), wo);
    check_no_gain(coated(alpha, conserving_base(white, table_of(alpha))), wo);
  });
}

TEST_CASE("energy: the same test finds the thesis' base out") {
  // alpha 0.1 at the cosine 0.1 (84.3 degrees): 1.1779, or a little more with the correlated G.
  const RunningMean mean = mean_weight(coated(0.1f, thesis_base(white)), at_cosine(0.1f), 10'000);
  CHECK(mean.mean() - 6 * mean.standard_error() > 1.15);
}

TEST_CASE("energy: sampled totals are those of the quadrature") {
  for (const float alpha : {0.1f, 0.6f})
    for (const float mu : {1.0f, 0.3f, 0.1f}) {
      const double expected = total_albedo({glass_index}, reciprocal_base(white), alpha, mu, 200);
      const RunningMean mean =
          mean_weight(coated(alpha, reciprocal_base(white)), at_cosine(mu), 20'000);
      CHECK(z_test(mean, expected).agrees(1e-3));
    }
}

TEST_CASE("energy: a white conserving base loses nothing") {
  for (const float alpha : {0.0f, 0.05f, 0.1f, 0.3f, 0.6f, 1.0f})
    for (const float mu : {1.0f, 0.8f, 0.5f, 0.3f, 0.1f, 0.02f})
      CHECK(white_total("conserving", alpha, mu, 100) == close_to(1.0, 2e-3));
}

TEST_CASE("energy: a coloured conserving base gives back E + albedo (1 - E)") {
  const SpecularAlbedo& table = table_of(0.3f);
  for (const float mu : {1.0f, 0.4f, 0.1f}) {
    const double e = table.at(mu);
    CHECK(total_albedo({glass_index}, conserving_base(Rgb(0.3f), table), 0.3f, mu, 150) ==
          close_to(e + 0.3 * (1 - e), 1e-3));
  }
}

TEST_CASE("energy: with half of the reflections a white conserving base still loses nothing") {
  const CoatFresnel half{glass_index, 0.5f};
  for (const float mu : {1.0f, 0.3f, 0.05f})
    CHECK(total_albedo(half, ConservingBase{white, 0.5f, table_of(0.3f)}, 0.3f, mu, 150) ==
          close_to(1.0, 2e-3));
}

TEST_CASE("energy: a smooth coat over the reciprocal base gives F + (1 - F)(1 - mean F)") {
  for (const float mu : {1.0f, 0.5f, 0.1f, 0.02f}) {
    const double f = fresnel_dielectric(double{mu}, 1.0, 1.5);
    CHECK(white_total("reciprocal", 0.0f, mu, 300) ==
          close_to(f + (1 - f) * (1 - mean_fresnel(1.5)), 1e-4));
  }
}
