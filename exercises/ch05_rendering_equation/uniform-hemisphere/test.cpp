#include "api.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "common/testkit/exercise.hpp"
#include "common/testkit/statistics.hpp"

namespace {

using exercise::uniform_hemisphere;
using exercise::uniform_hemisphere_pdf;
using glm::dvec2;
using glm::dvec3;

const double pi = std::acos(-1.0);
const double almost_one = 1.0 - 0x1p-53;

// In six digits; the largest u by its name.
std::string text_of(double x) {
  std::ostringstream text;
  text << (std::isnan(x) ? std::abs(x) : x);  // "-nan" says no more than "nan"
  return x == almost_one ? "1 - 2^-53" : text.str();
}

std::string gave(dvec2 u) {
  const dvec3 w = uniform_hemisphere(u);
  return "u = (" + text_of(u.x) + ", " + text_of(u.y) + ") gave (" + text_of(w.x) + ", " +
         text_of(w.y) + ", " + text_of(w.z) + ')';
}

// Every u of an even grid, and then of the rim.
std::vector<dvec2> places() {
  std::vector<double> one;
  for (int i = 0; i < 24; ++i)
    one.push_back((i + 0.5) / 24);
  one.insert(one.end(), {0.0, almost_one});
  std::vector<dvec2> all;
  for (const double x : one)
    for (const double y : one)
      all.emplace_back(x, y);
  return all;
}

// A right answer fails as rarely with fewer directions, so that thousands of seeds need no minutes.
std::size_t direction_count() {
  return lt::seeds().size() == 1 ? 100'000 : 20'000;
}

std::vector<dvec3> directions(std::uint64_t seed) {
  lt::TestRandom random(seed);
  std::vector<dvec3> all(direction_count());
  for (dvec3& w : all) {
    const double x = random.uniform();
    const double y = random.uniform();
    w = uniform_hemisphere({x, y});
  }
  return all;
}

// From a direction back to the unit square: each of these spreads one distribution evenly.
using Unfold = dvec2 (*)(dvec3 w);
double turn(dvec3 w) {
  const double part = std::atan2(w.y, w.x) / (2 * pi);
  return part < 0 ? part + 1 : part;
}
dvec2 from_uniform(dvec3 w) {
  return {w.z, turn(w)};
}
dvec2 from_half_turn(dvec3 w) {
  return {w.z, 2 * turn(w)};
}
dvec2 from_cosine(dvec3 w) {
  return {w.z * w.z, turn(w)};
}
dvec2 from_linear_theta(dvec3 w) {
  return {std::acos(w.z) / (pi / 2), turn(w)};
}

// How many fall in each of the square's 16 x 16 cells, one row after the other. At the end: how
// many fall beside it.
constexpr int side = 16;
std::vector<double> counted(const std::vector<dvec3>& all, Unfold unfold) {
  std::vector<double> counts(side * side + 1);
  for (const dvec3& w : all) {
    const dvec2 p = unfold(normalize(w));
    const bool is_inside = p.x > -1e-9 && p.x < 1 + 1e-9 && p.y > -1e-9 && p.y < 1 + 1e-9;
    const int row = is_inside ? std::clamp(static_cast<int>(p.x * side), 0, side - 1) : side;
    const int column = is_inside ? std::clamp(static_cast<int>(p.y * side), 0, side - 1) : 0;
    ++counts[static_cast<std::size_t>(row * side + column)];
  }
  return counts;
}

lt::ChiSquare evenness(const std::vector<dvec3>& all, Unfold unfold) {
  std::vector<double> expected(side * side, static_cast<double>(all.size()) / (side * side));
  expected.push_back(0);
  return lt::chi_square(counted(all, unfold), expected);
}

bool fits(const std::vector<dvec3>& all, Unfold unfold) {
  return evenness(all, unfold).p_value >= 1e-6;
}

std::string place_of_cell(std::ptrdiff_t index) {
  const double from = static_cast<double>(index / side) / side;
  const double to = from + 1.0 / side;
  const double phi = 360.0 * static_cast<double>(index % side) / side;
  std::ostringstream text;
  text.precision(3);
  text << "z " << from << " to " << to << ", phi " << phi << " to " << phi + 360.0 / side;
  return text.str();
}

// What a person can see of an uneven distribution: the emptiest and the fullest cell.
std::string unevenness(const std::vector<dvec3>& all) {
  std::vector<double> counts = counted(all, from_uniform);
  counts.pop_back();
  const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
  std::ostringstream text;
  text << "256 cells should hold about " << all.size() / 256 << " directions each. The emptiest ("
       << place_of_cell(least - counts.begin()) << " degrees) holds " << *least << ", the fullest ("
       << place_of_cell(most - counts.begin()) << ") " << *most << ".";
  return text.str();
}

double mean_cosine(const std::vector<dvec3>& all) {
  lt::RunningMean mean;
  for (const dvec3& w : all)
    mean.add(w.z);
  return mean.mean();
}

std::string seen(const std::vector<dvec3>& all) {
  std::ostringstream text;
  text << "The mean of z gave " << mean_cosine(all) << " and should give 0.5.";
  return text.str();
}

// The angle around the normal is 360 times one of the numbers, taken as radians: 57.3 turns, which
// no count of cells would show.
bool is_in_degrees() {
  int first = 0;
  int second = 0;
  for (const dvec2 u : {dvec2(0.21, 0.83), dvec2(0.47, 0.39), dvec2(0.68, 0.14)}) {
    const double phi = 2 * pi * turn(uniform_hemisphere(u));
    first += std::cos(phi - 360 * u.x) > 1 - 1e-6;
    second += std::cos(phi - 360 * u.y) > 1 - 1e-6;
  }
  return first == 3 || second == 3;
}

using Density = double (*)(double cos_theta);
bool is_density(Density density) {
  for (const double z : {0.2, 0.5, 0.9})
    if (!(std::abs(uniform_hemisphere_pdf(z) - density(z)) < 1e-6)) return false;
  return true;
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
  for (const dvec2 u : places())
    is_along_y = is_along_y && uniform_hemisphere(u).y >= 0;
  for (const dvec2 u : places()) {
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
  lt::diagnose(!is_in_degrees(), "angle-in-degrees", gave({0.21, 0.83}) + ".");
  for (const auto seed : lt::seeds()) {
    const std::vector<dvec3> all = directions(seed);
    const lt::ChiSquare even = evenness(all, from_uniform);
    if (even.p_value < 1e-6) {
      lt::diagnose(!fits(all, from_linear_theta), "theta-linear-in-u", seen(all));
      lt::diagnose(!fits(all, from_cosine), "cosine-sampled", seen(all));
      lt::diagnose(!fits(all, from_half_turn), "half-turn", unevenness(all));
      FAIL(unevenness(all));
    }
    // The mean of z is 1/2, of z^2 is 1/3: a standard deviation of sqrt(1/3 - 1/4).
    const double error = std::sqrt(1 / 12.0 / static_cast<double>(all.size()));
    INFO(seen(all));
    REQUIRE(lt::z_test(mean_cosine(all), error, 0.5).agrees(0.01));
    if (seed != 1) continue;
    std::ostringstream text;
    text << "100,000 directions have a mean cosine of " << mean_cosine(all) << "; chi-square gave "
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
