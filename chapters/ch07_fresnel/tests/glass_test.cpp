#include "ch07_fresnel/glass.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;

namespace {

constexpr float last = 1.0f - 0x1p-24f;  // the largest number that unit_float() makes
const Glass window{1.0f, 1.5f};
const Glass from_inside{1.5f, 1.0f};

vec3 at_degrees(float degrees) {
  return {std::sin(radians(degrees)), 0.0f, std::cos(radians(degrees))};
}

Surface glass_surface(bool outside) {
  Surface surface{};
  surface.outside = outside;
  surface.material.ior = 1.5f;
  return surface;
}

}  // namespace

static_assert(Bsdf<Glass>);

TEST_CASE("glass: straight on one sample in 25 is reflected and 24 go through") {
  Pcg32 random(1);
  RunningMean reflected;
  for (int i = 0; i < 1'000'000; ++i) {
    const auto sample = window.sample({0, 0, 1}, random.next_vec3());
    REQUIRE(sample);
    reflected.add(sample->wi.z > 0.0f);
  }
  CHECK(z_test(reflected, 1.0 / 25).agrees());
}

TEST_CASE("glass: at 60 degrees and from inside at 30 it reflects what Fresnel's equations say") {
  // 0.0891867 and 0.0551902: thesis eq. 4, evaluated independently.
  const std::pair<Glass, float> cases[] = {{window, 60.0f}, {from_inside, 30.0f}};
  const double expected[] = {0.0891867, 0.0551902};
  for (int which = 0; which < 2; ++which) {
    const auto& [glass, degrees] = cases[which];
    Pcg32 random(2);
    RunningMean reflected;
    for (int i = 0; i < 1'000'000; ++i)
      reflected.add(glass.sample(at_degrees(degrees), random.next_vec3())->wi.z > 0.0f);
    CHECK(z_test(reflected, expected[which]).agrees());
  }
}

TEST_CASE("glass: a reflection keeps radiance, one crossing scales it by the indices squared") {
  const auto into = window.sample(at_degrees(20), {0, 0, last});
  REQUIRE(into->wi.z < 0.0f);
  CHECK(into->weight == close_to(Rgb(1 / 2.25f), 1e-6));
  const auto out = from_inside.sample(at_degrees(20), {0, 0, last});
  REQUIRE(out->wi.z < 0.0f);
  CHECK(out->weight == close_to(Rgb(2.25f), 1e-6));
  for (const Glass& glass : {window, from_inside}) {
    const auto back = glass.sample(at_degrees(20), {0, 0, 0});
    CHECK(back->wi.z > 0.0f);
    CHECK(back->weight == Rgb(1.0f));
  }
}

TEST_CASE("glass: reciprocal up to the indices squared, along one ray") {
  // f(v, l) / n_v^2 = f(l, v) / n_l^2. A delta's f is T delta(l) / cos_l, T its weight times the
  // probability, and n_v^2 cos_v dv = n_l^2 cos_l dl (Snell, differentiated). Together:
  // T(v) n_l^2 / n_v^2 = T(l) n_v^2 / n_l^2.
  for (const float degrees : {0.0f, 10.0f, 45.0f, 60.0f, 80.0f, 89.0f}) {
    const vec3 wo = at_degrees(degrees);
    const auto through = window.sample(wo, {0, 0, last});
    REQUIRE(through->wi.z < 0.0f);
    const vec3 back(through->wi.x, through->wi.y, -through->wi.z);  // in the frame of that side
    const auto returned = from_inside.sample(back, {0, 0, last});
    REQUIRE(returned->wi.z < 0.0f);
    const float there = (1 - fresnel_dielectric(wo.z, 1.0f, 1.5f)) * through->weight.g;
    const float here = (1 - fresnel_dielectric(back.z, 1.5f, 1.0f)) * returned->weight.g;
    CHECK(there * 2.25f == Approx(here / 2.25f).epsilon(1e-3));
  }
}

TEST_CASE("glass: beyond the critical angle every sample is reflected") {
  Pcg32 random(3);
  for (int i = 0; i < 10'000; ++i) {
    const auto sample = from_inside.sample(at_degrees(42.0f), random.next_vec3());
    REQUIRE(sample);
    REQUIRE(sample->wi == close_to(vec3(-at_degrees(42).x, 0.0f, at_degrees(42).z), 1e-6));
  }
}

TEST_CASE("glass: it is a delta: no density, no value, and it says so") {
  const auto sample = window.sample(at_degrees(30), {0, 0, last});
  CHECK(is_delta(*sample));
  CHECK(window.eval(at_degrees(30), sample->wi) == Rgb(0.0f));
  CHECK(window.pdf(at_degrees(30), sample->wi) == 0.0f);
}

TEST_CASE("glass: of equal indices nothing is seen") {
  const Glass none{1.33f, 1.33f};
  Pcg32 random(4);
  for (const float degrees : {0.0f, 30.0f, 89.0f, 89.999f}) {
    const auto sample = none.sample(at_degrees(degrees), random.next_vec3());
    CHECK(sample->wi == close_to(-at_degrees(degrees), 1e-6));
    CHECK(sample->weight == Rgb(1.0f));
  }
}

TEST_CASE("glass: the index of the side from which one looks is that of air outside") {
  CHECK(glass_at(glass_surface(true)).n_here == 1.0f);
  CHECK(glass_at(glass_surface(true)).n_beyond == 1.5f);
  CHECK(glass_at(glass_surface(false)).n_here == 1.5f);
  CHECK(glass_at(glass_surface(false)).n_beyond == 1.0f);
}

TEST_CASE("glass: a million corners give unit directions, finite weights and no way behind") {
  const float cosines[] = {1e-15f, 1e-7f, 1e-4f, 1.0f - 0x1p-24f, 1.0f};
  const float indices[] = {1.0f, 1.0f - 1e-6f, 1.0f + 1e-6f, 1.5f, 2.42f, 1.0003f};
  const float numbers[] = {0.0f, 0x1p-24f, 0.5f, last};
  Pcg32 random(5);
  const auto any_of = [&](const auto& list) {
    return list[static_cast<int>(random.next_float() * static_cast<float>(std::size(list)))];
  };
  for (int i = 0; i < 1'000'000; ++i) {
    const float c = i % 2 == 0 ? any_of(cosines) : random.next_float();
    const float here = any_of(indices), beyond = any_of(indices);
    const vec3 wo(std::sqrt((1.0f - c) * (1.0f + c)), 0.0f, c);
    const auto sample = Glass{here, beyond}.sample(wo, {0, 0, any_of(numbers)});
    if (c == 0.0f && !sample) continue;  // along the surface
    const bool is_good = sample && std::abs(length(sample->wi) - 1.0f) < 1e-5f &&
                         sample->weight.g > 0.0f && sample->weight.g < 10.0f &&
                         (sample->wi.z != 0.0f);
    CAPTURE(c, here, beyond);
    if (!is_good) REQUIRE(false);
  }
  CHECK_FALSE(window.sample({1, 0, 0}, {0, 0, 0}));  // along the surface there is no side
}
