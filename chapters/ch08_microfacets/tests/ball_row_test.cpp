#include "ch08_microfacets/ball_row.hpp"

#include "ch04_monte_carlo/streams.hpp"
#include "ch05_rendering_equation/uniform_lambert.hpp"
#include "ch08_microfacets/tests/oracles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const AnyBrdf matt{[](vec3 wo, vec3 wi) { return lambert(Rgb(1.0f), wo, wi); }};

}  // namespace

TEST_CASE("far lamp: every direction ends on the lamp, and half of them in half its solid angle") {
  const FarLamp lamp{normalize(vec3(1, 2, -2)), radians(20.0f), 1.0f};
  const double middle = 1 - 0.5 * (1 - std::cos(20 * pi_ / 180));  // cosine of the inner half
  Pcg32 random(1);
  RunningMean inner;
  for (int i = 0; i < 100'000; ++i) {
    const vec3 w = lamp.sample(random.next_vec2());
    REQUIRE(length(w) == close_to(1.0, 1e-5));
    REQUIRE(dot(w, lamp.direction) >= std::cos(radians(20.001f)));
    inner.add(dot(w, lamp.direction) > middle);
  }
  CHECK(z_test(inner, 0.5).agrees());
  for (const vec2 u : {vec2(0, 0), vec2(1 - 0x1p-24f), vec2(0, 1 - 0x1p-24f)})
    CHECK(length(lamp.sample(u)) == close_to(1.0, 1e-6));
}

TEST_CASE("far lamp: a white matt surface that faces it gives back E / pi") {
  // The mean of f cos L / p with f = 1 / pi: E / pi.
  const FarLamp lamp{{0, 0, -1}, radians(30.0f), 3.0f};
  const Scene row = ball_row();
  const std::vector<AnyBrdf> brdfs(row_count, matt);
  const Ray ray{{0, 0, -5}, {0, 0, 1}};
  RunningMean mean;
  for (int i = 0; i < 100'000; ++i) {
    Pcg32 random = stream_for(1, 0, 0, i);
    mean.add(lamp_light(row, brdfs, lamp, ray, random).g);
  }
  CHECK(z_test(mean, 3 / pi_).agrees());
  CHECK(mean.mean() == Approx(3 / pi_).epsilon(1e-3));
}

TEST_CASE("far lamp: it can be as small as a point, and what is turned away from it is dark") {
  const FarLamp lamp{{0, 0, -1}, 1e-4f, 3.0f};
  const Scene row = ball_row();
  const std::vector<AnyBrdf> brdfs(row_count, matt);
  Pcg32 random(1);
  CHECK(lamp_light(row, brdfs, lamp, {{0, 0, -5}, {0, 0, 1}}, random).g ==
        Approx(3 / pi_).epsilon(1e-5));
  CHECK(lamp_light(row, brdfs, lamp, {{0, 0, 5}, {0, 0, -1}}, random).g == 0.0f);
  CHECK(lamp_light(row, brdfs, lamp, {{0, 0, -5}, {0, 1, 0}}, random).g == 0.02f);  // the backdrop
}

TEST_CASE("albedo table: it gives back what went in, and means between") {
  // A matt white surface has the albedo 1 everywhere.
  const AlbedoTable table(matt, 1.0f, 100);
  for (const float mu : {0.0f, 0.01f, 0.5f, 0.77f, 1.0f})
    CHECK(table.at(mu) == close_to(1.0, 1e-3));
  const AnyBrdf rough = brdf_named({}, Ggx{1.0f}, PerfectMirror{});
  const AlbedoTable lost(rough, 1.0f, 200);
  CHECK(lost.at(1.0f) == close_to(1 - std::log(2.0), 1e-4));
  CHECK(lost.at(2.0f) == lost.at(1.0f));
}

TEST_CASE("sky: a ball that loses nothing cannot be seen, one of alpha 1 can") {
  const Scene row = ball_row();
  std::vector<AlbedoTable> albedos(row_count, AlbedoTable(matt, 1.0f, 100));
  const Ray to_middle{{0, 0, -5}, {0, 0, 1}};
  CHECK(sky_light(row, albedos, to_middle).g == close_to(0.5, 1e-3));
  CHECK(sky_light(row, albedos, {{0, 0, -5}, {0, 1, 0}}).g == 0.5f);
  albedos[3] = AlbedoTable(brdf_named({}, Ggx{1.0f}, PerfectMirror{}), 1.0f, 100);
  CHECK(sky_light(row, albedos, to_middle).g == close_to(0.5 * (1 - std::log(2.0)), 1e-3));
}
