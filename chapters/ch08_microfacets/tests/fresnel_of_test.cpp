#include "ch08_microfacets/fresnel_of.hpp"

#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;

static_assert(FresnelTerm<DielectricFresnel>);
static_assert(FresnelTerm<ConductorFresnel>);
static_assert(FresnelTerm<PerfectMirror>);

TEST_CASE("fresnel of: glass gives 0.04 straight on, from both sides, and all at the horizon") {
  CHECK(DielectricFresnel{1.0f, 1.5f}(1.0f) == close_to(Rgb(0.04f), 1e-7));
  CHECK(DielectricFresnel{1.5f, 1.0f}(1.0f) == close_to(Rgb(0.04f), 1e-7));
  CHECK(DielectricFresnel{1.0f, 1.5f}(0.0f) == Rgb(1.0f));
  CHECK(DielectricFresnel{1.5f, 1.0f}(0.5f) == Rgb(1.0f));  // 60 degrees, beyond 41.8
}

TEST_CASE("fresnel of: a metal's share is multiplied by its tint") {
  // ((0.277 - 1)^2 + 2.92^2) / ((0.277 + 1)^2 + 2.92^2) = 0.890914, the thesis' gold.
  const Rgb tint(1.0f, 0.851246f, 0.301305f);
  CHECK(ConductorFresnel{{Rgb(0.277f), Rgb(2.92f)}, tint}(1.0f) ==
        close_to(0.890914f * tint, 1e-6));
  CHECK(ConductorFresnel{gold}(0.0f) == close_to(Rgb(1.0f), 1e-6));
}

TEST_CASE("fresnel of: a perfect mirror reflects all, whatever the angle") {
  for (const float cosine : {0.0f, 0.3f, 1.0f})
    CHECK(PerfectMirror{}(cosine) == Rgb(1.0f));
}
