#include "ch06_importance_sampling/cosine_hemisphere.hpp"

#include <numbers>

#include "ch04_monte_carlo/pcg32.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/sampler_test.hpp"

using namespace lt;

namespace {

constexpr float largest = 1.0f - 0x1p-24f;  // the largest number that unit_float() makes

double pdf(vec3 direction) {
  return cosine_hemisphere_pdf(direction.z);
}

// Any other way to an even point of the disk: darts at a square, until one lands on the disk.
vec2 disk_by_rejection(Pcg32& random) {
  for (;;) {
    const vec2 dart = 2.0f * random.next_vec2() - 1.0f;
    if (dot(dart, dart) < 1.0f) return dart;
  }
}

}  // namespace

TEST_CASE("disk: every u gives a point of the disk, the middle for u = 0 and the rim near 1") {
  CHECK(uniform_disk({0.0f, 0.4f}) == vec2(0.0f));
  CHECK(length(uniform_disk({largest, 0.25f}) - vec2(0, 1)) < 1e-6f);
  for (const float y : {0.0f, 0.3f, largest})
    for (const float x : {0.0f, 0.25f, 0.5f, largest})
      CHECK(length(uniform_disk({x, y})) == Approx(std::sqrt(x)).margin(1e-6));
}

TEST_CASE("disk: rings of equal area get equal shares") {
  // The ring inside radius r has the share r^2 of the area: r^2 is uniform in (0, 1).
  Pcg32 random(1);
  std::vector<double> squares, turns;
  for (int i = 0; i < 100'000; ++i) {
    const glm::dvec2 p = uniform_disk(random.next_vec2());
    squares.push_back(dot(p, p));
    turns.push_back(0.5 + std::atan2(p.y, p.x) / (2 * std::numbers::pi));
  }
  const auto even = [](double x) { return std::clamp(x, 0.0, 1.0); };
  CHECK(kolmogorov_smirnov(squares, even).p_value > 1e-6);
  CHECK(kolmogorov_smirnov(turns, even).p_value > 1e-6);
}

TEST_CASE("cosine hemisphere: directions are unit and above the horizon for every u") {
  for (const float x : {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.999f, largest})
    for (const float y : {0.0f, 0.25f, 0.7f, largest}) {
      const vec3 w = cosine_hemisphere({x, y});
      CAPTURE(x, y, w);
      CHECK(length(w) == Approx(1).epsilon(2e-7));
      CHECK(w.z > 0.0f);
      CHECK(w.z <= 1.0f);
    }
  CHECK(cosine_hemisphere({0.0f, 0.3f}) == vec3(0, 0, 1));
}

TEST_CASE("cosine hemisphere: it is the thesis' equation 18 with z for its y") {
  Pcg32 random(2);
  for (int i = 0; i < 1000; ++i) {
    const vec2 u = random.next_vec2();
    const double phi = 2 * std::numbers::pi * u.y;
    const glm::dvec3 thesis(std::sqrt(u.x) * std::cos(phi), std::sqrt(1 - double{u.x}),
                            std::sqrt(u.x) * std::sin(phi));
    const vec3 w = cosine_hemisphere(u);
    REQUIRE(length(glm::dvec3(w.x, w.z, w.y) - thesis) < 1e-6);
  }
}

TEST_CASE("cosine hemisphere: mean of z is 2/3 and the squares share 1/2, 1/4, 1/4") {
  // z has the density 2z: E[z] = 2/3, E[z^2] = 1/2. x^2 + y^2 = 1 - z^2 shares its half evenly, and
  // all odd means vanish by symmetry.
  Pcg32 random(1);
  RunningMean z, zz, x, y, xx, yy, xy, xz;
  for (int i = 0; i < 1'000'000; ++i) {
    const glm::dvec3 w = cosine_hemisphere(random.next_vec2());
    z.add(w.z), zz.add(w.z * w.z), x.add(w.x), y.add(w.y);
    xx.add(w.x * w.x), yy.add(w.y * w.y), xy.add(w.x * w.y), xz.add(w.x * w.z);
  }
  CHECK(z_test(z, 2.0 / 3).agrees());
  CHECK(z_test(zz, 1.0 / 2).agrees());
  CHECK(z_test(xx, 1.0 / 4).agrees());
  CHECK(z_test(yy, 1.0 / 4).agrees());
  CHECK(z_test(x, 0).agrees());
  CHECK(z_test(y, 0).agrees());
  CHECK(z_test(xy, 0).agrees());
  CHECK(z_test(xz, 0).agrees());
}

TEST_CASE("cosine hemisphere: its density integrates to one and is zero below the horizon") {
  CHECK(integrate_directions(pdf) == Approx(1).epsilon(1e-6));
  CHECK(cosine_hemisphere_pdf(-0.5f) == 0.0f);
  CHECK(cosine_hemisphere_pdf(1.0f) == Approx(1 / std::numbers::pi));
}

TEST_CASE("cosine hemisphere: chi-square over bins of the sphere") {
  Pcg32 random(3);
  const auto draw = [&] { return std::optional(cosine_hemisphere(random.next_vec2())); };
  for (const RowSpacing spacing : {RowSpacing::equal_z, RowSpacing::equal_angle}) {
    const SamplerReport report =
        test_sampler(draw, pdf, {1'000'000, DirectionBins(24, 32, spacing)});
    INFO(report.complaint);
    CHECK(report.complaint.empty());
  }
}

TEST_CASE("cosine hemisphere: any even point of the disk has the same density when it is lifted") {
  // Malley: the patch above a small area dA of the disk has the solid angle dA / cos(theta).
  Pcg32 random(4);
  const auto draw = [&]() -> std::optional<vec3> {
    const vec2 p = disk_by_rejection(random);
    return vec3(p, std::sqrt(1.0f - dot(p, p)));
  };
  const SamplerReport report = test_sampler(draw, pdf);
  INFO(report.complaint);
  CHECK(report.complaint.empty());
}
