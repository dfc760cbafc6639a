#include "ch07_fresnel/schlick.hpp"

#include "ch07_fresnel/fresnel.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;

TEST_CASE("schlick: right at the normal and at the horizon, a fifth power in between") {
  for (const double at_normal : {0.0, 0.04, 0.9}) {
    CHECK(schlick(1.0, at_normal) == at_normal);
    CHECK(schlick(0.0, at_normal) == 1.0);
    CHECK(schlick(0.5, at_normal) == close_to(at_normal + (1 - at_normal) / 32, 1e-15));
  }
}

TEST_CASE("schlick: at 60 degrees glass loses a fifth of its reflection to it") {
  // 0.04 + 0.96 / 32 = 0.07 for 0.0892 (errata of thesis eq. 4).
  CHECK(schlick(0.5, 0.04) / fresnel_dielectric(0.5, 1.0, 1.5) == close_to(0.07 / 0.0891867, 1e-6));
}
