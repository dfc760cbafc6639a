#include "ch05_rendering_equation/uniform_hemisphere.hpp"

#include <numbers>
#include <vector>

#include "ch04_monte_carlo/pcg32.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;

namespace {

constexpr double exact_pi = std::numbers::pi;
constexpr float largest = 1.0f - 0x1p-24f;  // the largest number that unit_float() makes

}  // namespace

TEST_CASE("uniform hemisphere: directions are unit and above the horizon for every u") {
  for (const float x : {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.999f, largest})
    for (const float y : {0.0f, 0.25f, 0.7f, largest}) {
      const vec3 w = uniform_hemisphere({x, y});
      CAPTURE(x, y, w);
      CHECK(length(w) == Approx(1).epsilon(2e-7));
      CHECK(w.z > 0.0f);
      CHECK(w.z <= 1.0f);
    }
  CHECK(uniform_hemisphere({0.0f, 0.3f}) == vec3(0, 0, 1));
}

TEST_CASE("uniform hemisphere: means of z and of squares are one half and one third") {
  // By Archimedes z is uniform in (0, 1): E[z] = 1/2, E[z^2] = 1/3; x^2 + y^2 = 1 - z^2 shares its
  // 2/3 evenly; x, y and every product of two coordinates average to 0 by symmetry.
  Pcg32 random(1);
  RunningMean z, zz, x, y, xx, yy, xy, xz;
  for (int i = 0; i < 1'000'000; ++i) {
    const glm::dvec3 w = uniform_hemisphere(random.next_vec2());
    z.add(w.z), zz.add(w.z * w.z), x.add(w.x), y.add(w.y);
    xx.add(w.x * w.x), yy.add(w.y * w.y), xy.add(w.x * w.y), xz.add(w.x * w.z);
  }
  CHECK(z_test(z, 1.0 / 2).agrees());
  CHECK(z_test(zz, 1.0 / 3).agrees());
  CHECK(z_test(xx, 1.0 / 3).agrees());
  CHECK(z_test(yy, 1.0 / 3).agrees());
  CHECK(z_test(x, 0).agrees());
  CHECK(z_test(y, 0).agrees());
  CHECK(z_test(xy, 0).agrees());
  CHECK(z_test(xz, 0).agrees());
}

TEST_CASE("uniform hemisphere: its density integrates to one") {
  const auto in_angles = [](double theta, double) {
    return uniform_hemisphere_pdf * std::sin(theta);  // dw = sin(theta) dtheta dphi
  };
  CHECK(integrate_2d(in_angles, 0, exact_pi / 2, 0, 2 * exact_pi) == Approx(1).epsilon(1e-6));
}

TEST_CASE("uniform hemisphere: chi-square over bins of theta and phi") {
  constexpr int thetas = 12;
  constexpr int phis = 24;
  constexpr int samples = 1'000'000;
  std::vector<double> observed(thetas * phis);
  std::vector<double> expected;
  for (int i = 0; i < thetas; ++i) {
    const double high = std::cos(exact_pi / 2 * i / thetas);
    const double low = std::cos(exact_pi / 2 * (i + 1) / thetas);
    const double solid_angle = (high - low) * 2 * exact_pi / phis;
    expected.insert(expected.end(), phis, samples * solid_angle / (2 * exact_pi));
  }
  Pcg32 random(2);
  for (int n = 0; n < samples; ++n) {
    const glm::dvec3 w = uniform_hemisphere(random.next_vec2());
    const double theta = std::acos(std::min(w.z, 1.0));
    const double phi = std::atan2(w.y, w.x) + exact_pi;
    const int i = std::min(thetas - 1, static_cast<int>(theta / (exact_pi / 2) * thetas));
    const int j = std::min(phis - 1, static_cast<int>(phi / (2 * exact_pi) * phis));
    ++observed[static_cast<std::size_t>(i * phis + j)];
  }
  CHECK(chi_square(observed, expected).p_value > 1e-6);
}
