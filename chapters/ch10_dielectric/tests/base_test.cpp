#include "ch10_dielectric/base.hpp"

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch10_dielectric/tests/coats.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const vec3 up(0, 0, 1);
const Rgb white(1.0f);

template <CoatedBase Base>
void require_reciprocal(const Base& base, Pcg32& random) {
  const vec3 wo = uniform_hemisphere(random.next_vec2());
  const vec3 wi = uniform_hemisphere(random.next_vec2());
  const Rgb there = base.eval(wo, wi);
  REQUIRE(there.g > 0.0f);
  REQUIRE(distance(base.eval(wi, wo), there) <= 1e-4f * length(there));
}

}  // namespace

TEST_CASE("bases: straight through glass, thesis' and reciprocal are 0.96 squared of Lambert's") {
  // F = ((1.5 - 1) / (1.5 + 1))^2 = 0.04 at normal incidence, in and out.
  const Rgb tint(0.2f, 0.5f, 0.9f);
  const Rgb expected = tint * static_cast<float>(0.96 * 0.96 / pi_);
  CHECK(thesis_base(tint).eval(up, up) == close_to(expected, 1e-6));
  CHECK(reciprocal_base(tint).eval(up, up) == close_to(expected, 1e-6));
}

TEST_CASE("bases: the thesis' looks at the facet, the reciprocal one at the surface") {
  // wo and wi both at 60 degrees on the same side: the facet between them is met straight on, the
  // surface at 60 degrees, where F = 0.0891867.
  const vec3 w = at_degrees(60);
  CHECK(thesis_base(white).eval(w, w).g == close_to(0.96 * 0.96 / pi_, 1e-6));
  const double through = 1 - 0.0891867;
  CHECK(reciprocal_base(white).eval(w, w).g == close_to(through * through / pi_, 1e-6));
}

TEST_CASE("bases: light goes both ways alike, for 10,000 pairs of directions") {
  Pcg32 random(1);
  for (int i = 0; i < 10'000; ++i) {
    require_reciprocal(thesis_base(white), random);
    require_reciprocal(reciprocal_base(white), random);
    require_reciprocal(conserving_base(white, table_of(0.3f)), random);
  }
}

TEST_CASE("bases: the thesis' gives back what the published errata of it say, by quadrature") {
  // Row "diffuse alone", white, index 1.5.
  const std::pair<float, double> rows[] = {{1.0f, 0.9194}, {0.8f, 0.9149}, {0.5f, 0.9032},
                                           {0.3f, 0.8904}, {0.2f, 0.8820}, {0.1f, 0.8720},
                                           {0.02f, 0.8628}};
  for (const auto& [mu, expected] : rows)
    CHECK(base_albedo(thesis_base(white), at_cosine(mu), 300) == close_to(expected, 1e-4));
}

TEST_CASE("bases: the reciprocal one gives back (1 - F)(1 - mean F)") {
  // The integral of (1 - F(mu)) mu over the hemisphere is pi (1 - mean F).
  for (const float mu : {1.0f, 0.5f, 0.1f, 0.02f}) {
    const double through = 1 - fresnel_dielectric(double{mu}, 1.0, 1.5);
    CHECK(base_albedo(reciprocal_base(white), at_cosine(mu), 300) ==
          close_to(through * (1 - mean_fresnel(1.5)), 1e-4));
  }
}

TEST_CASE("bases: the conserving one gives back all that the coat does not reflect") {
  for (const float alpha : five_alphas)
    for (const float mu : {1.0f, 0.5f, 0.1f, 0.02f})
      CHECK(base_albedo(conserving_base(white, table_of(alpha)), at_cosine(mu), 200) ==
            close_to(1.0 - double{table_of(alpha).at(mu)}, 1e-3));
}

TEST_CASE("bases: under a coat that reflects nothing all three are Lambert's") {
  const Rgb tint(0.2f, 0.5f, 0.9f);
  const CoatFresnel none{glass_index, 0.0f};
  const vec3 wo = slanting(70), wi = at_degrees(30);
  CHECK(ThesisBase{tint, none}.eval(wo, wi) == close_to(tint / pi, 1e-7));
  CHECK(ReciprocalBase{tint, none}.eval(wo, wi) == close_to(tint / pi, 1e-7));
  CHECK(ConservingBase{tint, 0.0f, table_of(0.1f)}.eval(wo, wi) == close_to(tint / pi, 1e-7));
}

TEST_CASE("bases: nothing comes from below or goes there") {
  const auto check = [](const auto& base) {
    for (const vec3 low : {vec3(1, 0, 0), vec3(0.6f, 0.0f, -0.8f)}) {
      CHECK(base.eval(low, up) == Rgb(0.0f));
      CHECK(base.eval(up, low) == Rgb(0.0f));
    }
  };
  check(thesis_base(white));
  check(reciprocal_base(white));
  check(conserving_base(white, table_of(0.3f)));
}

TEST_CASE("bases: the share that they choose by is that of their mean colour") {
  const Rgb tint(0.1f, 0.2f, 0.6f);  // mean 0.3
  const vec3 wo = at_degrees(60);
  CHECK(thesis_base(tint).share(wo) == close_to(0.3 * 0.96 * 0.96, 1e-6));
  CHECK(reciprocal_base(tint).share(wo) == close_to(0.3 * (1 - 0.0891867), 1e-6));
  CHECK(conserving_base(tint, table_of(0.3f)).share(wo) ==
        close_to(0.3 * (1.0 - double{table_of(0.3f).at(wo.z)}), 1e-6));
}
