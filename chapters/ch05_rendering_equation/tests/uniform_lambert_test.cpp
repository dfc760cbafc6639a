#include "ch05_rendering_equation/uniform_lambert.hpp"

#include <numbers>
#include <vector>

#include "ch04_monte_carlo/pcg32.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;

namespace {

constexpr double exact_pi = std::numbers::pi;
const UniformLambert chalk{{0.5f, 0.8f, 0.2f}};
const vec3 slanting = normalize(vec3(0.6f, -0.3f, 0.4f));

}  // namespace

TEST_CASE("lambert: over the hemisphere it gives back its albedo") {
  // The integral of f cos(theta) over the directions wi, in angles.
  for (int channel = 0; channel < 3; ++channel) {
    const auto in_angles = [&](double theta, double phi) {
      const vec3 wi(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                    std::cos(theta));
      return double{chalk.eval(slanting, wi)[channel]} * std::cos(theta) * std::sin(theta);
    };
    CHECK(integrate_2d(in_angles, 0, exact_pi / 2, 0, 2 * exact_pi, 1e-6) ==
          Approx(chalk.albedo[channel]).epsilon(1e-5));
  }
}

TEST_CASE("lambert: it is the same from everywhere and both ways round and 0 through the wall") {
  const vec3 up(0, 0, 1);
  CHECK(chalk.eval(up, slanting) == chalk.eval(slanting, up));
  CHECK(chalk.eval(up, up) == chalk.eval(slanting, up));
  CHECK(chalk.eval(up, -slanting) == Rgb(0.0f));
  CHECK(chalk.eval(-up, slanting) == Rgb(0.0f));
  CHECK(chalk.eval(-up, -slanting) == chalk.eval(up, slanting));
}

TEST_CASE("uniform lambert: weight times pdf is f times cosine") {
  Pcg32 random(3);
  for (int i = 0; i < 10'000; ++i) {
    const auto sample = chalk.sample(slanting, random.next_vec3());
    REQUIRE(sample);
    REQUIRE(sample->pdf == chalk.pdf(slanting, sample->wi));
    REQUIRE(sample->wi.z > 0.0f);
    const Rgb expected = chalk.eval(slanting, sample->wi) * sample->wi.z;
    for (int c = 0; c < 3; ++c)
      REQUIRE(sample->weight[c] * sample->pdf == Approx(expected[c]).epsilon(1e-6));
  }
}

TEST_CASE("uniform lambert: the mean weight is the albedo and its variance a third of the square") {
  // Weight = 2 a z, z uniform in (0, 1): mean a, variance 4 a^2 / 12.
  Pcg32 random(4);
  RunningMean weight;
  for (int i = 0; i < 1'000'000; ++i)
    weight.add(chalk.sample(slanting, random.next_vec3())->weight.g);
  CHECK(z_test(weight, chalk.albedo.g).agrees());
  CHECK(weight.variance() == Approx(chalk.albedo.g * chalk.albedo.g / 3).epsilon(0.01));
}

TEST_CASE("uniform lambert: the density is that of the directions that come out") {
  // Bins of equal solid angle, in z and phi: by the density each expects the same share.
  constexpr int bins = 16;
  constexpr double samples = 400'000;
  std::vector<double> observed(bins * bins);
  const double solid_angle = 2 * exact_pi / (bins * bins);
  const std::vector<double> expected(
      bins * bins, samples * solid_angle * chalk.pdf(slanting, normalize(vec3(1, 2, 3))));
  Pcg32 random(5);
  for (int n = 0; n < samples; ++n) {
    const glm::dvec3 w = chalk.sample(slanting, random.next_vec3())->wi;
    const int i = std::min(bins - 1, static_cast<int>(w.z * bins));
    const double turn = (std::atan2(w.y, w.x) + exact_pi) / (2 * exact_pi);
    const int j = std::min(bins - 1, static_cast<int>(turn * bins));
    ++observed[static_cast<std::size_t>(i * bins + j)];
  }
  CHECK(chi_square(observed, expected).p_value > 1e-6);
  CHECK(chalk.pdf(slanting, -slanting) == 0.0f);
}
