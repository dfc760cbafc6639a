#include "api.hpp"

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/hemisphere.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::uniform_hemisphere;
using exercise::uniform_hemisphere_pdf;
using glm::dvec2;
using glm::dvec3;

const double pi = std::acos(-1.0);

std::string gave(dvec2 u) {
  return lt::text_of_sample(uniform_hemisphere, u);
}

// Even if only half of the angles around z occur.
dvec2 unfold_half_turn(dvec3 w) {
  return {w.z, 2 * lt::turn(w)};
}

std::string unevenness(const std::vector<dvec3>& all) {
  return lt::text_of_unevenness(all, lt::unfold_uniform, [](double height) { return height; });
}

std::string seen(const std::vector<dvec3>& all) {
  std::ostringstream text;
  text << "The mean of z gave " << lt::mean_z(all) << " and should give 0.5.";
  return text.str();
}

bool is_density(lt::DensityOfZ density) {
  return lt::is_same_density(uniform_hemisphere_pdf, density);
}

std::string density_gave(double z) {
  std::ostringstream text;
  text << "The density at z = " << z << " gave " << uniform_hemisphere_pdf(z) << " and should give "
       << (z < 0 ? 0 : 1 / (2 * pi)) << '.';
  return text.str();
}

}  // namespace

TEST_CASE("every direction is 1 long and points away from the surface") {
  bool is_along_y = true;
  for (const dvec2 u : lt::places_on_square())
    is_along_y = is_along_y && uniform_hemisphere(u).y >= 0;
  for (const dvec2 u : lt::places_on_square()) {
    const dvec3 w = uniform_hemisphere(u);
    INFO(gave(u));
    REQUIRE((std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.z)));
    std::ostringstream is_long;
    is_long << gave(u) << ", which is " << length(w) << " long and should be 1.";
    lt::diagnose(std::abs(length(w) - 1) < 1e-6, "not-unit", is_long.str());
    lt::diagnose(!(is_along_y && w.z < -1e-6), "normal-along-y", gave(u) + ".");
    lt::diagnose(w.z > -1e-6, "below-horizon", gave(u) + ".");
  }
}

TEST_CASE("height and angle each have a number of their own") {
  for (const auto& [a, b] :
       {std::pair(dvec2(0.3, 0.1), dvec2(0.3, 0.6)), std::pair(dvec2(0.1, 0.3), dvec2(0.6, 0.3))})
    lt::diagnose(distance(uniform_hemisphere(a), uniform_hemisphere(b)) > 1e-6, "same-number-twice",
                 gave(a) + ", and " + gave(b) + ".");
}

TEST_CASE("equal areas get equal numbers of directions") {
  lt::diagnose(!lt::is_turned_in_degrees(uniform_hemisphere), "angle-in-degrees",
               gave({0.21, 0.83}) + ".");
  for (const auto seed : lt::seeds()) {
    const std::vector<dvec3> all = lt::draw_directions(uniform_hemisphere, seed);
    const lt::ChiSquare even = lt::evenness(all, lt::unfold_uniform);
    if (even.p_value < 1e-6) {
      lt::diagnose(!lt::is_spread_evenly(all, lt::unfold_linear_theta), "theta-linear-in-u",
                   seen(all));
      lt::diagnose(!lt::is_spread_evenly(all, lt::unfold_cosine), "cosine-sampled", seen(all));
      lt::diagnose(!lt::is_spread_evenly(all, unfold_half_turn), "half-turn", unevenness(all));
      FAIL(unevenness(all));
    }
    // The mean of z is 1/2, of z^2 is 1/3: a standard deviation of sqrt(1/3 - 1/4).
    const double error = std::sqrt(1 / 12.0 / static_cast<double>(all.size()));
    INFO(seen(all));
    REQUIRE(lt::z_test(lt::mean_z(all), error, 0.5).agrees(0.01));
    if (seed != 1) continue;
    std::ostringstream text;
    text << "100,000 directions have a mean cosine of " << lt::mean_z(all) << "; chi-square gave "
         << even.statistic << " for " << even.degrees_of_freedom << " degrees of freedom";
    lt::measured(text.str());
  }
}

TEST_CASE("the density is the same all over the hemisphere, 1 in sum, and 0 below it") {
  lt::diagnose(!is_density([](double) { return 1 / (4 * pi); }), "pdf-of-full-sphere",
               density_gave(0.5));
  lt::diagnose(!is_density([](double z) { return std::sqrt(1 - z * z) / (2 * pi); }),
               "pdf-per-angle", density_gave(0.5));
  lt::diagnose(!is_density([](double) { return pi / 2; }), "pdf-pi-above", density_gave(0.5));
  for (const double z : {0.2, 0.5, 0.9}) {
    INFO(density_gave(z));
    REQUIRE(std::abs(uniform_hemisphere_pdf(z) - 1 / (2 * pi)) < 1e-6);
  }
  for (const double z : {-0.001, -0.5, -1.0})
    lt::diagnose(uniform_hemisphere_pdf(z) == 0, "pdf-below-horizon", density_gave(z));
  // A ring of height dz has the area 2 pi dz.
  const double sum =
      lt::integrate([](double z) { return 2 * pi * uniform_hemisphere_pdf(z); }, 0, 1);
  CHECK(std::abs(sum - 1) < 1e-5);
}
