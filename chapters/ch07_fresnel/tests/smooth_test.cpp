#include "ch07_fresnel/smooth.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch07_fresnel/tests/surface_of.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const Material clear{.attenuation = Rgb(0.0f)};
const Material metal{
    .tint = Rgb(0.5f), .ior = 0.277f, .extinction = 2.92f, .type = MaterialType::metal};
const vec3 slanting = normalize(vec3(0.3f, -0.5f, 0.6f));

template <class T>
bool is_a(const SmoothBsdf& bsdf) {
  return std::holds_alternative<T>(bsdf.kind);
}

}  // namespace

static_assert(Bsdf<SmoothBsdf>);
static_assert(Bsdf<OneOf<CosineLambert>>);

TEST_CASE("smooth: metals are mirrors, clear dielectrics are glass, all else is matt") {
  CHECK(is_a<Mirror>(smooth_bsdf_at(surface_of(metal))));
  CHECK(is_a<Glass>(smooth_bsdf_at(surface_of(clear))));
  CHECK(is_a<CosineLambert>(smooth_bsdf_at(surface_of({}))));
  CHECK(is_a<CosineLambert>(smooth_bsdf_at(surface_of({.type = MaterialType::plastic}))));
  // Who swallows light in one color only is clear in the others: the thesis' clear sphere.
  CHECK(is_a<Glass>(smooth_bsdf_at(surface_of({.attenuation = {0.0f, 1.0f, 0.666f}}))));
}

TEST_CASE("smooth: each kind answers as it does alone") {
  const auto check_same = [](const SmoothBsdf& one, const auto& alone) {
    Pcg32 random(1);
    for (int i = 0; i < 1000; ++i) {
      const vec3 u = random.next_vec3();
      const auto a = one.sample(slanting, u);
      const auto b = alone.sample(slanting, u);
      REQUIRE(a.has_value());
      REQUIRE(a->wi == b->wi);
      REQUIRE(a->weight == b->weight);
      REQUIRE(a->pdf == b->pdf);
      REQUIRE(one.eval(slanting, a->wi) == alone.eval(slanting, a->wi));
      REQUIRE(one.pdf(slanting, a->wi) == alone.pdf(slanting, a->wi));
    }
  };
  check_same(smooth_bsdf_at(surface_of({.tint = Rgb(0.3f)})), CosineLambert{Rgb(0.3f)});
  check_same(smooth_bsdf_at(surface_of(metal)), Mirror{{Rgb(0.277f), Rgb(2.92f)}, Rgb(0.5f)});
  check_same(smooth_bsdf_at(surface_of(clear)), Glass{1.0f, 1.5f});
  check_same(smooth_bsdf_at(surface_of(clear, false)), Glass{1.5f, 1.0f});
}

TEST_CASE("smooth: a matt one of three is still sampled as its density says") {
  const SmoothBsdf matt = smooth_bsdf_at(surface_of({.tint = {0.2f, 0.5f, 0.9f}}));
  Pcg32 random(2);
  CHECK(triple_complaint(matt, slanting, 10'000, random) == "");
}

TEST_CASE("smooth: where a scene has its metal, the material's single numbers are not asked") {
  const SmoothWithMetal scatter{gold};
  const auto sample = scatter(surface_of(metal)).sample({0, 0, 1}, vec3(0.0f));
  CHECK(sample->weight == Mirror{gold}.sample({0, 0, 1}, vec3(0.0f))->weight);
  CHECK(is_a<Glass>(scatter(surface_of(clear))));
}
