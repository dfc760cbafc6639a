#include <limits>

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch07_fresnel/fresnel.hpp"
#include "ch07_fresnel/metals.hpp"
#include "ch07_fresnel/tests/oracles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

// The thesis' gold, real gold, silver, copper; iron-like, soot-like, nearly clear, a sheer
// absorber.
constexpr double metals[8][2] = {{0.277, 2.92}, {0.21, 3.272}, {0.06, 4.152}, {1.02, 2.577},
                                 {2.9, 3.1},    {1.8, 0.6},    {1.5, 1e-3},   {1.0, 7.0}};

}  // namespace

TEST_CASE("conductor: straight on it has the closed form of Fresnel's quotient") {
  // |(m - 1) / (m + 1)|^2 with m = eta + i k.
  for (const auto& [eta, k] : metals) {
    const double exact = ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
    CHECK(fresnel_conductor(1.0, 1.0, eta, k) == close_to(exact, 1e-14));
  }
  // From inside water the metal's index is divided by that of the water.
  const double eta = 0.277 / 1.33, k = 2.92 / 1.33;
  const double exact = ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
  CHECK(fresnel_conductor(1.0, 1.33, 0.277, 2.92) == close_to(exact, 1e-14));
}

TEST_CASE("conductor: 8 metals and 1000 angles agree with complex arithmetic") {
  for (const auto& [eta, k] : metals)
    for (const double here : {1.0, 1.33})
      for (int i = 0; i < 1000; ++i) {
        const double c = i * largest_cosine_step;
        const double exact = complex_reflectance(c, {eta / here, k / here}).mean();
        CAPTURE(eta, k, here, c);
        REQUIRE(fresnel_conductor(c, here, eta, k) == close_to(exact, 1e-12));
        REQUIRE(fresnel_conductor(static_cast<float>(c), static_cast<float>(here),
                                  static_cast<float>(eta),
                                  static_cast<float>(k)) == close_to(exact, 2e-6));
      }
}

TEST_CASE("conductor: without extinction it is the dielectric from both sides") {
  for (const double n : {1.04, 1.33, 1.5, 2.42, 4.0})
    for (int i = 0; i < 1000; ++i) {
      const double c = i * largest_cosine_step;
      CAPTURE(n, c);
      REQUIRE(fresnel_conductor(c, 1.0, n, 0.0) == close_to(fresnel_dielectric(c, 1.0, n), 1e-11));
      REQUIRE(fresnel_conductor(c, n, 1.0, 0.0) == close_to(fresnel_dielectric(c, n, 1.0), 1e-7));
    }
  CHECK(fresnel_conductor(0.0, 1.5, 1.5, 0.0) == 0.0);
}

TEST_CASE("conductor: at the horizon everything is reflected") {
  for (const auto& [eta, k] : metals)
    CHECK(fresnel_conductor(0.0, 1.0, eta, k) == 1.0);
}

TEST_CASE("conductor: the channels keep their order") {
  const Rgb share = fresnel_conductor(0.7f, 1.0f, gold.eta, gold.k);
  for (int c = 0; c < 3; ++c)
    CHECK(share[c] == fresnel_conductor(0.7f, 1.0f, gold.eta[c], gold.k[c]));
  CHECK(share.r > share.g);  // or it would not be gold
  CHECK(share.g > share.b);
}

TEST_CASE("fresnel: a million corners give shares between 0 and 1 and nothing else") {
  constexpr float tiny = std::numeric_limits<float>::min();
  const float cosines[] = {0.0f, tiny, 1e-20f, 1e-7f, 1e-4f, 1.0f - 0x1p-24f, 1.0f, 1.0000001f};
  const float indices[] = {1.0f,  1.0f - 1e-6f, 1.0f + 1e-6f, 1.0f - 0x1p-24f, 1.0f + 0x1p-23f,
                           1e-3f, 1.5f,         100.0f};
  const float extinctions[] = {0.0f, 1e-6f, 1e-3f, 1.0f, 100.0f};
  Pcg32 random(1);
  const auto any_of = [&](const auto& list) {
    return list[static_cast<int>(random.next_float() * static_cast<float>(std::size(list)))];
  };
  for (int i = 0; i < 1'000'000; ++i) {
    const float c = i % 2 == 0 ? any_of(cosines) : random.next_float();
    const float here = any_of(indices), beyond = any_of(indices), k = any_of(extinctions);
    const float clear = fresnel_dielectric(c, here, beyond);
    const float metal = fresnel_conductor(c, here, beyond, k);
    CAPTURE(c, here, beyond, k, clear, metal);
    if (!(clear >= 0.0f && clear <= 1.0f)) REQUIRE(false);
    if (!(metal >= 0.0f && metal <= 1.0f)) REQUIRE(false);
  }
}
