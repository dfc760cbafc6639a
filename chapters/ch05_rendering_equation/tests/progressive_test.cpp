#include "ch05_rendering_equation/progressive.hpp"

#include "ch05_rendering_equation/plots.hpp"
#include "ch05_rendering_equation/tests/program_checks.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const std::atomic<bool> never{false};

// Uniform between 0 and 1 in each colour: variance 1/12.
Rgb white_noise(const Ray&, Pcg32& random) {
  return random.next_vec3();
}

}  // namespace

TEST_CASE("progressive: passes double what is there and the last one fills up") {
  Film film(5, 4);
  std::vector<std::int64_t> counts;
  render_in_passes(film, Camera(), white_noise, 20, {}, never,
                   [&](const Film& before, const Film& all) {
                     CHECK(before.at(4, 3).count == (counts.empty() ? 0 : counts.back()));
                     counts.push_back(all.at(4, 3).count);
                   });
  CHECK(counts == std::vector<std::int64_t>{1, 2, 4, 8, 16, 20});
}

TEST_CASE("progressive: passes make the same bytes as one go") {
  Film in_passes(9, 7);
  render_in_passes(in_passes, Camera(), white_noise, 13, {.seed = 3}, never,
                   [](const Film&, const Film&) {});
  Film in_one_go(9, 7);
  render(in_one_go, Camera(), white_noise, {.last = 13, .seed = 3}, never);
  require_same_samples(in_passes, in_one_go);
}

TEST_CASE("progressive: no pass begins after a cancellation and its film is told") {
  std::atomic<bool> cancel{false};
  int passes = 0;
  Film film(9, 7);
  render_in_passes(film, Camera(), white_noise, 64, {}, cancel, [&](const Film&, const Film& all) {
    ++passes;
    cancel = all.at(0, 0).count == 4;
  });
  CHECK(passes == 3);
  CHECK(summary(film).most == 4);
}

TEST_CASE("noise: of uniform numbers it is the root of a twelfth over n") {
  // 64 x 48 pixels of 3 colours are 9,216 squares of normal numbers, whose mean has a relative
  // error of sqrt(2 / 9216) = 1.5 %; its root has half of that. Six of them.
  Film film(64, 48);
  render_in_passes(film, Camera(), white_noise, 200, {}, never,
                   [](const Film& before, const Film& all) {
                     const auto measured = pixel_noise(before, all);
                     const auto n = static_cast<double>(all.at(0, 0).count);
                     CHECK(measured.has_value() == (n > 1));
                     if (measured)
                       CHECK(*measured == Approx(std::sqrt(1 / (12 * n))).epsilon(0.05));
                   });
}

TEST_CASE("noise: a pixel that the newest pass has not reached does not count") {
  Film before(2, 1);
  before.add(0, 0, Rgb(1.0f));
  before.add(1, 0, Rgb(7.0f));
  Film after = before;
  CHECK_FALSE(pixel_noise(before, after));
  after.add(0, 0, Rgb(4.0f));  // 1 and 4: their mean errs by half of 3
  CHECK(*pixel_noise(before, after) == Approx(1.5));
}

TEST_CASE("noise: it falls with the root of the number of samples") {
  const HollowSphere half_lit{{.emission = Rgb(1.0f), .tint = Rgb(0.8f)}};
  const auto estimate = [&](const Ray& ray, Pcg32& random) {
    return radiance_recursive(half_lit, uniform_lambert_at, ray, 4, random);
  };
  const auto measured = measure_noise(Camera(), estimate, 64, 48, 256, {}, never);
  REQUIRE(measured.size() == 8);
  CHECK(law_of(measured).slope == Approx(-0.5).margin(0.02));
}

TEST_CASE("noise: the fitted line is the one that was drawn") {
  std::vector<NoiseAt> drawn;
  for (double n = 2; n <= 512; n *= 2)
    drawn.push_back({n, 3 * std::pow(n, -0.37)});
  CHECK(law_of(drawn).slope == Approx(-0.37));
  CHECK(law_of(drawn).factor == Approx(3));
}
