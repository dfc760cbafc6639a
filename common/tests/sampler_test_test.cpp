#include "common/testkit/sampler_test.hpp"

#include <limits>
#include <numbers>

#include "common/testkit/catch.hpp"
#include "common/testkit/exercise.hpp"

using namespace lt;

namespace {

constexpr double exact_pi = std::numbers::pi;
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// Uniform numbers in the form that triple_complaint() asks for.
struct Random {
  TestRandom numbers{1};
  float next() {
    return static_cast<float>(static_cast<double>(numbers.next_bits() >> 40) * 0x1p-24);
  }
  vec3 next_vec3() {
    const float x = next();
    const float y = next();
    const float z = next();
    return {x, y, z};
  }
};

vec3 around(double z, double turn) {
  const double radius = std::sqrt(std::max(0.0, 1 - z * z));
  return {radius * std::cos(2 * exact_pi * turn), radius * std::sin(2 * exact_pi * turn), z};
}

// Archimedes: z is uniform where directions are.
vec3 uniform_up(vec3 u) {
  return around(1 - double{u.x}, u.y);
}
double uniform_up_pdf(vec3 w) {
  return w.z > 0 ? 1 / (2 * exact_pi) : 0;
}
// P(z' < z) = z^2.
vec3 cosine_up(vec3 u) {
  return around(std::sqrt(1 - double{u.x}), u.y);
}
double cosine_up_pdf(vec3 w) {
  return std::max(0.0, w.z / exact_pi);
}

template <class Warp>
DrawDirection drawing(Random& random, const Warp& warp) {
  return [&random, warp] { return std::optional<vec3>(warp(random.next_vec3())); };
}

bool says(const std::string& complaint, const std::string& part) {
  CAPTURE(complaint);
  return complaint.find(part) != std::string::npos;
}

struct Sample {
  vec3 wi, weight;
  float pdf;
};
// Lambert's surface, and ways of getting it wrong.
struct Matt {
  float weight = 0.5f;      // what sample() says
  float claimed = 1;        // factor on the density that sample() says
  float blind_above = 2;    // no density for z above this
  float value = 0.5f / pi;  // eval

  std::optional<Sample> sample(vec3 wo, vec3 u) const {
    const vec3 wi = cosine_up(u);
    return Sample{wi, vec3(weight), claimed * pdf(wo, wi)};
  }
  vec3 eval(vec3, vec3 wi) const { return vec3(wi.z > 0 ? value : 0.0f); }
  float pdf(vec3, vec3 wi) const {
    return wi.z > blind_above ? 0.0f : static_cast<float>(cosine_up_pdf(wi));
  }
};

std::string triple_of(const Matt& matt) {
  Random random;
  return triple_complaint(matt, vec3(0, 0, 1), 1000, random);
}

}  // namespace

TEST_CASE("direction bins: a direction lies between the edges of its bin") {
  TestRandom random(1);
  for (const RowSpacing spacing : {RowSpacing::equal_z, RowSpacing::equal_angle})
    for (const ivec2 size : {ivec2{2, 1}, ivec2{10, 7}, ivec2{24, 32}}) {
      const DirectionBins bins(size.x, size.y, spacing);
      REQUIRE(bins.size() == static_cast<std::size_t>(size.x * size.y));
      for (int i = 0; i < 1000; ++i) {
        const vec3 w = random.direction();
        const auto index = static_cast<int>(bins.index_of(w));
        const int row = index / bins.columns();
        const int column = index % bins.columns();
        REQUIRE(w.z >= bins.z_edge(row));
        REQUIRE(w.z <= bins.z_edge(row + 1));
        double phi = std::atan2(double{w.y}, double{w.x});
        if (phi < 0) phi += 2 * exact_pi;
        REQUIRE(phi >= bins.phi_edge(column));
        REQUIRE(phi <= bins.phi_edge(column + 1));
      }
      for (const vec3 w : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0), vec3(1, -1e-30f, 0),
                           vec3(-1, -0.0f, 0), vec3(0, -1, -0.0f)})
        CHECK(bins.index_of(w) < bins.size());
      CHECK(bins.index_of({1, 0, 0}) / size.y == static_cast<std::size_t>(size.x / 2));
      CHECK(bins.index_of({1, 0, -1e-9f}) / size.y == static_cast<std::size_t>(size.x / 2 - 1));
    }
}

TEST_CASE("direction bins: a constant integrates to the solid angle of each bin") {
  const DirectionBins equal(12, 9);
  for (const double angle : integrate_bins(equal, [](vec3) { return 1.0; }))
    REQUIRE(angle == Approx(4 * exact_pi / (12 * 9)).epsilon(1e-12));
  // Between polar angles a and b: (cos a - cos b) dphi.
  const auto angles =
      integrate_bins(DirectionBins(6, 4, RowSpacing::equal_angle), [](vec3) { return 1.0; });
  CHECK(angles[0] == Approx((1 - std::sqrt(0.75)) * exact_pi / 2).epsilon(1e-12));
  CHECK(angles[4] == Approx((std::sqrt(0.75) - 0.5) * exact_pi / 2).epsilon(1e-12));
}

TEST_CASE("direction bins: quadrature finds closed forms, edges and narrow peaks") {
  // The squares of three coordinates share 4 pi evenly.
  CHECK(integrate_directions([](vec3 w) { return double{w.x} * w.x; }) ==
        Approx(4 * exact_pi / 3).epsilon(1e-6));
  CHECK(integrate_directions(cosine_up_pdf) == Approx(1).epsilon(1e-6));
  // A cap of half angle acos(0.9) around a slanting axis: 2 pi (1 - 0.9). Its edge jumps from 1 to
  // 0, which costs accuracy.
  const vec3 axis = normalize(vec3(1, 2, 1.5f));
  const auto cap = [&](vec3 w) { return dot(w, axis) > 0.9f ? 1.0 : 0.0; };
  CHECK(integrate_directions(cap) == Approx(0.2 * exact_pi).epsilon(1e-3));
  // Von Mises and Fisher's density around it: k / (2 pi (1 - exp(-2k))) exp(k (cos - 1)).
  for (const double k : {1.0, 100.0, 10'000.0}) {
    const auto peak = [&](vec3 w) {
      const glm::dvec3 off = glm::dvec3(w) - glm::dvec3(axis);  // |off|^2 / 2 = 1 - cos
      return k / (2 * exact_pi * (1 - std::exp(-2 * k))) * std::exp(-k * dot(off, off) / 2);
    };
    CHECK(integrate_directions(peak) == Approx(1).epsilon(1e-4));
  }
}

TEST_CASE("sampler test: right samplers pass and their p-values are uniform") {
  Random random;
  std::vector<double> p_values;
  for (int i = 0; i < 100; ++i) {
    const auto uniform = test_sampler(drawing(random, uniform_up), uniform_up_pdf, {20'000});
    const auto cosine = test_sampler(drawing(random, cosine_up), cosine_up_pdf, {20'000});
    REQUIRE(uniform.complaint.empty());
    REQUIRE(cosine.complaint.empty());
    p_values.push_back(uniform.chi_square.p_value);
    p_values.push_back(cosine.chi_square.p_value);
  }
  CHECK(kolmogorov_smirnov(p_values, [](double p) { return p; }).p_value > 1e-6);
}

TEST_CASE("sampler test: a wrong density shows with the statistic that it must have") {
  // Uniform samples against the cosine's density: beyond the degrees of freedom the statistic grows
  // by n sum (p_uniform - p_cosine)^2 / p_cosine. Rows of z from i / 12 to (i + 1) / 12 have the
  // shares 1/12 and (2i + 1) / 144; the columns share evenly.
  double growth = 0;
  for (int i = 0; i < 12; ++i)
    growth += std::pow(1.0 / 12 - (2 * i + 1) / 144.0, 2) / ((2 * i + 1) / 144.0);
  Random random;
  for (const int n : {400'000, 1'000'000}) {
    const auto report = test_sampler(drawing(random, uniform_up), cosine_up_pdf, {n});
    CHECK(says(report.complaint, "do not follow the density"));
    CHECK(report.chi_square.degrees_of_freedom == 12 * 32 - 1);
    // Its spread: 2 sqrt(n growth) from the growth, little else.
    CHECK(report.chi_square.statistic == Approx(n * growth).epsilon(0.05));
  }
  CHECK_FALSE(test_sampler(drawing(random, cosine_up), uniform_up_pdf).complaint.empty());
}

TEST_CASE("sampler test: only the azimuth wrong is wrong too") {
  Random random;
  const auto lopsided = [](vec3 u) { return around(1 - double{u.x}, std::pow(double{u.y}, 1.02)); };
  CHECK_FALSE(test_sampler(drawing(random, lopsided), uniform_up_pdf).complaint.empty());
}

TEST_CASE("sampler test: draws that lead nowhere are what the density leaves of one") {
  Random random;
  const DrawDirection losing = [&]() -> std::optional<vec3> {
    const vec3 u = random.next_vec3();
    if (u.z < 0.3f) return std::nullopt;
    return cosine_up(u);
  };
  const auto right = test_sampler(losing, [](vec3 w) { return 0.7 * cosine_up_pdf(w); });
  CHECK(right.complaint.empty());
  CHECK(right.integral == Approx(0.7).epsilon(1e-6));
  CHECK(right.observed.back() == Approx(300'000).epsilon(0.01));  // 6 sigma are 0.9 %
  // Whoever takes the loss for nothing, or draws again, has another density.
  CHECK_FALSE(test_sampler(losing, cosine_up_pdf).complaint.empty());
  CHECK_FALSE(test_sampler(drawing(random, cosine_up), [](vec3 w) {
                return 0.7 * cosine_up_pdf(w);
              }).complaint.empty());
}

TEST_CASE("sampler test: what cannot be a direction or a density is said") {
  Random random;
  const SamplerOptions few{1000};
  const auto complaint = [&](const DrawDirection& draw, const DirectionFunction& pdf) {
    return test_sampler(draw, pdf, few).complaint;
  };
  const DrawDirection fine = drawing(random, cosine_up);
  CHECK(complaint(fine, cosine_up_pdf).empty());
  CHECK(says(complaint(drawing(random, [](vec3 u) { return 0.9f * cosine_up(u); }), cosine_up_pdf),
             "not unit"));
  CHECK(says(complaint(drawing(random, [](vec3) { return vec3(not_a_number); }), cosine_up_pdf),
             "not unit"));
  CHECK(says(complaint(fine, [](vec3 w) { return 2 * cosine_up_pdf(w); }), "more than 1"));
  CHECK(says(complaint(fine, [](vec3) { return double{not_a_number}; }), "more than 1"));
  CHECK_FALSE(complaint(fine, [](vec3 w) { return w.z / exact_pi; }).empty());  // negative below
  CHECK_FALSE(complaint(fine, [](vec3) { return 0.0; }).empty());
  // One sample where none may be is enough.
  int drawn = 0;
  const DrawDirection slips = [&]() -> std::optional<vec3> {
    if (drawn++ == 500) return vec3(0, 0, -1);
    return cosine_up(random.next_vec3());
  };
  CHECK_FALSE(complaint(slips, cosine_up_pdf).empty());
}

TEST_CASE("triple: sample, eval and pdf that belong together pass") {
  CHECK(triple_of({}).empty());
  CHECK(triple_of({.weight = 0.7f, .value = 0.7f / pi}).empty());
}

TEST_CASE("triple: each part that disagrees with the others is named") {
  CHECK(says(triple_of({.weight = 0.6f}), "but eval |cos| / pdf is"));
  CHECK(says(triple_of({.value = 0.4f / pi}), "but eval |cos| / pdf is"));
  CHECK(says(triple_of({.claimed = 1.001f}), "pdf() says"));
  CHECK(says(triple_of({.blind_above = 0.95f}), "its density is 0"));
  CHECK(says(triple_of({.weight = -0.5f}), "its weight is"));
  CHECK(says(triple_of({.weight = not_a_number}), "its weight is"));
  CHECK(says(triple_of({.value = not_a_number}), "(nan"));
}

TEST_CASE("triple: a part of the sphere that nobody samples is named") {
  const vec3 light(0, 0, -1);
  CHECK(says(complaint_about_unsampled(light, vec3(0.1f), 0), "no sample goes there"));
  CHECK(complaint_about_unsampled(light, vec3(0), 0).empty());
  CHECK(complaint_about_unsampled(light, vec3(0.1f), 0.2f).empty());
  CHECK(says(complaint_about_unsampled(light, vec3(-0.1f), 0.2f), "eval |cos| is"));
  CHECK(says(complaint_about_unsampled(light, vec3(0.1f), not_a_number), "its density is"));
  CHECK(says(complaint_about_unsampled(light, vec3(0.1f), -1), "its density is"));
}
