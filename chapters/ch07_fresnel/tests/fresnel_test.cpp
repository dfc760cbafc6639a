#include "ch07_fresnel/fresnel.hpp"

#include "ch07_fresnel/special_angles.hpp"
#include "ch07_fresnel/tests/oracles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/testkit/statistics.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

constexpr double indices[] = {1.0003, 1.04, 1.33, 1.5, 1.77, 2.0, 2.42, 4.0};

double at_degrees(double angle, double n_here, double n_beyond) {
  return fresnel_dielectric(std::cos(angle * exact_pi / 180), n_here, n_beyond);
}

// In float, of what these numbers become there: near the critical angle, where the curve is
// vertical, the cosine beyond is the root of a small difference.
void check_float(double cos_here, double n_here, double n_beyond) {
  const auto c = static_cast<float>(cos_here);
  const auto here = static_cast<float>(n_here), beyond = static_cast<float>(n_beyond);
  const double m = double{beyond} / double{here};
  const double exact = complex_reflectance(c, m).mean();
  const double cos_beyond = std::sqrt(std::abs(squared_cos_beyond<double>(c, 1 / m)));
  REQUIRE(fresnel_dielectric(c, here, beyond) == close_to(exact, 1e-6 + 1e-6 / cos_beyond));
}

}  // namespace

TEST_CASE("dielectric: straight on it is the squared difference of the indices over their sum") {
  // For 1.5 it is (0.5 / 2.5)^2 = 1/25, for 3 it is (2 / 4)^2 = 1/4, whichever side one looks from.
  CHECK(fresnel_dielectric(1.0, 1.0, 1.5) == close_to(0.04, 1e-15));
  CHECK(fresnel_dielectric(1.0, 1.5, 1.0) == close_to(0.04, 1e-15));
  CHECK(fresnel_dielectric(1.0, 1.0, 3.0) == close_to(0.25, 1e-15));
  CHECK(fresnel_dielectric(1.0f, 1.0f, 1.5f) == close_to(0.04, 1e-7));
}

TEST_CASE("dielectric: values between are those of the angles' sines and tangents") {
  // Fresnel 1823: r_s = -sin(i - t) / sin(i + t), r_p = tan(i - t) / tan(i + t).
  for (const double n : indices)
    for (int degrees = 1; degrees < 90; ++degrees) {
      const double i = degrees * exact_pi / 180;
      const double t = std::asin(std::sin(i) / n);
      const double s = std::sin(i - t) / std::sin(i + t);
      const double p = std::tan(i - t) / std::tan(i + t);
      REQUIRE(at_degrees(degrees, 1.0, n) == close_to((s * s + p * p) / 2, 1e-13));
    }
  // 60 degrees into 1.5: sin t = 1 / sqrt(3), r_s = (1 - 3 sqrt(2/3)) / (1 + 3 sqrt(2/3)) and
  // r_p = (3 - 2 sqrt(2/3)) / (3 + 2 sqrt(2/3)), all from the exact cosines 1/2 and sqrt(2/3).
  const double root = std::sqrt(2.0 / 3.0);
  const double s = (1 - 3 * root) / (1 + 3 * root);
  const double p = (1.5 - 2 * root) / (1.5 + 2 * root);
  CHECK(at_degrees(60, 1.0, 1.5) == close_to((s * s + p * p) / 2, 1e-15));
}

TEST_CASE("dielectric: it equals the thesis' equation 4 where that is a number") {
  // Walter et al. 2007, eq. 22: g^2 = (n_beyond / n_here)^2 - 1 + c^2.
  for (const double n : indices)
    for (const bool is_outside : {true, false})
      for (int i = 1; i < 1000; ++i) {
        const double c = i * largest_cosine_step;
        const double here = is_outside ? 1 : n;
        const double beyond = is_outside ? n : 1;
        const double squared_g = std::pow(beyond / here, 2) - 1 + c * c;
        if (squared_g < 1e-6) continue;
        const double g = std::sqrt(squared_g);
        const double left = std::pow((g - c) / (g + c), 2) / 2;
        const double right = 1 + std::pow((c * (g + c) - 1) / (c * (g - c) + 1), 2);
        REQUIRE(fresnel_dielectric(c, here, beyond) == close_to(left * right, 1e-11));
      }
}

TEST_CASE("dielectric: 8 indices and 1000 angles agree with complex arithmetic from both sides") {
  for (const double n : indices)
    for (int i = 0; i < 1000; ++i) {
      const double c = i * largest_cosine_step;
      for (const bool is_outside : {true, false}) {
        const double here = is_outside ? 1 : n;
        const double beyond = is_outside ? n : 1;
        const ComplexReflectance exact = complex_reflectance(c, beyond / here);
        const Reflectance<double> found = reflectance_dielectric(c, here, beyond);
        CAPTURE(n, c, is_outside);
        REQUIRE(found.s == close_to(exact.s, 1e-11));
        REQUIRE(found.p == close_to(exact.p, 1e-11));
        check_float(c, here, beyond);
      }
    }
}

TEST_CASE("dielectric: at Brewster's angle light that swings in the plane is not reflected") {
  for (const double n : indices) {
    const double outside = brewster_angle(1.0, n);
    const double inside = brewster_angle(n, 1.0);
    CHECK(outside + inside == close_to(exact_pi / 2, 1e-14));  // the rays beyond are each other's
    for (const bool is_outside : {true, false}) {
      const double c = std::cos(is_outside ? outside : inside);
      const auto share = reflectance_dielectric(c, is_outside ? 1.0 : n, is_outside ? n : 1.0);
      CHECK(share.p == close_to(0.0, 1e-25));
      // There cos_here = 1 / sqrt(1 + n^2), cos_beyond = n / sqrt(1 + n^2), so r_s^2 is this:
      CHECK(share.s == close_to(std::pow((n * n - 1) / (n * n + 1), 2), 1e-13));
    }
  }
  CHECK(brewster_angle(1.0, 1.5) * 180 / exact_pi == close_to(56.3099, 1e-4));  // atan(3/2)
}

TEST_CASE("dielectric: beyond the critical angle everything is reflected and before it less") {
  CHECK(*critical_angle(1.5, 1.0) * 180 / exact_pi == close_to(41.8103, 1e-4));  // asin(2/3)
  for (const double n : indices) {
    const double critical = *critical_angle(n, 1.0);
    CHECK_FALSE(critical_angle(1.0, n));
    CHECK(fresnel_dielectric(std::cos(critical + 1e-9), n, 1.0) == 1.0);
    CHECK(fresnel_dielectric(0.0, n, 1.0) == 1.0);
    const double before = fresnel_dielectric(std::cos(critical - 1e-9), n, 1.0);
    CHECK(before < 1.0);
    CHECK(before > 0.99);  // no jump
  }
  CHECK_FALSE(critical_angle(1.5, 1.5));
}

TEST_CASE("dielectric: along one ray it is the same from both sides") {
  for (const double n : indices)
    for (int i = 1; i < 1000; ++i) {
      const double c = i * largest_cosine_step;
      const double beyond = std::sqrt(squared_cos_beyond(c, 1.0 / n));
      REQUIRE(fresnel_dielectric(c, 1.0, n) == close_to(fresnel_dielectric(beyond, n, 1.0), 1e-11));
    }
}

TEST_CASE("dielectric: only the quotient of the indices counts") {
  for (int i = 0; i <= 100; ++i)
    CHECK(fresnel_dielectric(i / 100.0, 1.33, 1.5) ==
          close_to(fresnel_dielectric(i / 100.0, 1.0, 1.5 / 1.33), 1e-12));
}

TEST_CASE("dielectric: between equal indices there is no surface, at no angle") {
  for (const double c : {0.0, 1e-300, 1e-9, 0.5, 1.0})
    CHECK(fresnel_dielectric(c, 1.5, 1.5) == 0.0);
}

TEST_CASE("dielectric: the means over all directions fit together, inside and outside") {
  // 1 - F_inside = (1 - F_outside) / n^2: as much light comes out as goes in. For 1.5 the outer
  // mean has a closed form (Walsh 1926; in this shape Duntley 1942):
  const auto walsh = [](double n) {
    const double a = n * n, m = a - 1, p = a + 1;
    return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
           a * m * m / (p * p * p) * std::log((n - 1) / (n + 1)) -
           2 * n * a * (a + 2 * n - 1) / (p * (a * a - 1)) +
           8 * a * a * (a * a + 1) / (p * (a * a - 1) * (a * a - 1)) * std::log(n);
  };
  for (const double n : {1.33, 1.5, 2.42}) {
    const auto mean = [](double here, double beyond, double from) {
      return integrate([=](double c) { return 2 * c * fresnel_dielectric(c, here, beyond); }, from,
                       1.0);
    };
    const double critical = std::sqrt(1 - 1 / (n * n));  // the cosine; below it all is reflected
    const double outside = mean(1, n, 0);
    const double inside = critical * critical + mean(n, 1, critical);
    CHECK(outside == close_to(walsh(n), 1e-8));
    CHECK(1 - inside == close_to((1 - outside) / (n * n), 1e-8));
  }
}
