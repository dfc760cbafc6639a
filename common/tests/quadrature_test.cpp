#include <cmath>
#include <limits>
#include <numbers>

#include "common/testkit/catch.hpp"
#include "common/testkit/statistics.hpp"

using std::numbers::pi;

namespace {

double normal_density(double x, double mean, double sigma) {
  const double z = (x - mean) / sigma;
  return std::exp(-z * z / 2) / (sigma * std::sqrt(2 * pi));
}

}  // namespace

TEST_CASE("quadrature: integrals with closed forms") {
  CHECK(lt::integrate([](double x) { return std::sin(x); }, 0, pi) == Approx(2).epsilon(1e-13));
  CHECK(lt::integrate([](double x) { return std::pow(x, 20); }, 0, 1) == Approx(1.0 / 21));
  CHECK(lt::integrate([](double x) { return std::exp(-x); }, 0, 50) == Approx(1).epsilon(1e-10));
  CHECK(lt::integrate([](double x) { return std::pow(std::sin(100 * x), 2); }, 0, pi) ==
        Approx(pi / 2).epsilon(1e-10));
  CHECK(lt::integrate([](double) { return 3.0; }, -2, 5) == Approx(21).epsilon(1e-14));
}

TEST_CASE("quadrature: direction counts, and an empty interval is nothing") {
  CHECK(lt::integrate([](double x) { return x; }, 1, 0) == Approx(-0.5));
  CHECK(lt::integrate([](double x) { return x; }, 2, 2) == 0);
  CHECK(lt::integrate_2d([](double, double) { return 1.0; }, 1, 1, 0, 5) == 0);
  CHECK(lt::integrate_2d([](double, double) { return 1.0; }, 1, 0, 0, 5) == Approx(-5));
}

TEST_CASE("quadrature: kinks, jumps and poles at the end") {
  CHECK(lt::integrate([](double x) { return std::abs(x - 1 / pi); }, 0, 1) ==
        Approx((1 / (pi * pi) + std::pow(1 - 1 / pi, 2)) / 2).epsilon(1e-10));
  CHECK(lt::integrate([](double x) { return x < 1 / pi ? 1.0 : 0.0; }, 0, 1) ==
        Approx(1 / pi).epsilon(1e-9));
  CHECK(lt::integrate([](double x) { return std::log(x); }, 0, 1) == Approx(-1).epsilon(1e-9));
  CHECK(lt::integrate([](double x) { return 1 / std::sqrt(x); }, 0, 1) == Approx(2).epsilon(1e-8));
}

TEST_CASE("quadrature: sharp peaks are found and followed") {
  for (const double where : {0.1, 0.25, 0.3, 0.5, 0.77}) {
    CHECK(lt::integrate([&](double x) { return normal_density(x, where, 0.003); }, 0, 1) ==
          Approx(1).epsilon(1e-9));
    // Lorentz' curve with half-width 1e-5.
    const double w = 1e-5;
    const auto curve = [&](double x) { return 1 / (w * w + (x - where) * (x - where)); };
    CHECK(lt::integrate(curve, 0, 1) ==
          Approx((std::atan((1 - where) / w) + std::atan(where / w)) / w).epsilon(1e-9));
  }
}

TEST_CASE("quadrature: a function that computes in float ends soon, as exact as it can be") {
  int calls = 0;
  const auto noisy = [&](double x) {
    ++calls;
    return static_cast<double>(std::sin(static_cast<float>(x)));
  };
  CHECK(lt::integrate(noisy, 0, pi) == Approx(2).epsilon(1e-7));
  CHECK(calls < 10'000);
  calls = 0;
  CHECK(lt::integrate_2d([&](double x, double y) { return noisy(x) * noisy(y); }, 0, pi, 0, pi) ==
        Approx(4).epsilon(1e-6));
  CHECK(calls < 10'000'000);
}

TEST_CASE("quadrature: NaN and infinity are passed on") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(lt::integrate([&](double x) { return x > 0.5 ? nan : 1.0; }, 0, 1)));
  CHECK_FALSE(std::isfinite(lt::integrate([](double x) { return 1 / (x - 0.0625); }, 0, 1)));
}

TEST_CASE("quadrature: over a rectangle") {
  // The sphere's area, and the volume under the hemisphere of radius 1 over a square inside it.
  const auto sphere = [](double, double theta) { return std::sin(theta); };
  CHECK(lt::integrate_2d(sphere, 0, 2 * pi, 0, pi) == Approx(4 * pi).epsilon(1e-10));
  CHECK(lt::integrate_2d([](double x, double y) { return x * y * y; }, 0, 2, -1, 2) ==
        Approx(2 * 3).epsilon(1e-12));
  // A normal peak in the plane.
  const auto peak = [](double x, double y) {
    return normal_density(x, 0.3, 0.01) * normal_density(y, 0.6, 0.02);
  };
  CHECK(lt::integrate_2d(peak, 0, 1, 0, 1) == Approx(1).epsilon(1e-7));
}

TEST_CASE("quadrature: a microfacet distribution's projected area is 1") {
  // GGX (Walter et al. 2007, eq. 33, anisotropic form of Burley 2012), integrated over the
  // hemisphere with the cosine: 1 by definition of a distribution of normals.
  const auto area = [](double alpha_x, double alpha_y) {
    const auto density = [&](double phi, double theta) {
      const double x = std::sin(theta) * std::cos(phi) / alpha_x;
      const double y = std::sin(theta) * std::sin(phi) / alpha_y;
      const double z = std::cos(theta);
      const double d = 1 / (pi * alpha_x * alpha_y * std::pow(x * x + y * y + z * z, 2));
      return d * z * std::sin(theta);
    };
    return lt::integrate_2d(density, 0, 2 * pi, 0, pi / 2);
  };
  CHECK(area(0.5, 0.5) == Approx(1).epsilon(1e-7));
  CHECK(area(0.02, 0.02) == Approx(1).epsilon(1e-7));
  CHECK(area(0.05, 0.5) == Approx(1).epsilon(1e-7));
}

TEST_CASE("quadrature: an edge through the rectangle does not take forever") {
  int calls = 0;
  const auto quarter_disk = [&](double x, double y) {
    ++calls;
    return x * x + y * y < 1 ? 1.0 : 0.0;
  };
  CHECK(lt::integrate_2d(quarter_disk, 0, 1, 0, 1, 1e-6) == Approx(pi / 4).margin(1e-5));
  CHECK(calls < 2'000'000);
}
