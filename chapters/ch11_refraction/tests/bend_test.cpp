#include "ch11_refraction/bend.hpp"

#include "ch11_refraction/tests/glasses.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

// The bent ray by Snell's law, in double.
glm::dvec3 bent(glm::dvec3 wo, glm::dvec3 h, double eta) {
  const double c = glm::dot(wo, h);
  return (eta * c - std::sqrt(1 - eta * eta * (1 - c * c))) * h - eta * wo;
}

// A facet, a direction in front of it and the one behind it into which it bends.
struct Bent {
  vec3 wo, h, wi;
};

std::optional<Bent> any_bend(Pcg32& random, float n_here, float n_beyond) {
  const vec3 wo = uniform_hemisphere(random.next_vec2());
  const vec3 h = VisibleNormals::sample(Ggx{0.5f}, wo, random.next_vec2());
  const auto wi = refracted(wo, h, n_here / n_beyond);
  if (!wi || !(wi->z < -0.01f) || !(dot(wo, h) > 0.01f)) return std::nullopt;
  return Bent{wo, h, *wi};
}

template <class F>
void over_bends(float n_here, float n_beyond, const F& f) {
  Pcg32 random(1);
  int found = 0;
  while (found < 1000)
    if (const auto bend = any_bend(random, n_here, n_beyond)) {
      ++found;
      f(*bend);
    }
}

constexpr std::pair<float, float> pairs[] = {{1.0f, 1.5f}, {1.5f, 1.0f}, {1.0f, 2.4f},
                                             {2.4f, 1.0f}, {1.0f, 1.2f}, {1.33f, 1.5f}};

}  // namespace

TEST_CASE("half vector of transmission: straight through it is the normal, from both sides") {
  const vec3 up(0, 0, 1);
  CHECK(transmission_half_vector(up, -up, 1.0f, 1.5f) == up);
  CHECK(transmission_half_vector(up, -up, 1.5f, 1.0f) == up);
}

TEST_CASE("half vector of transmission: it is the facet that bent the ray") {
  for (const auto& [here, beyond] : pairs)
    over_bends(here, beyond, [here = here, beyond = beyond](const Bent& b) {
      CAPTURE(here, beyond, b.wo, b.h, b.wi);
      REQUIRE(transmission_half_vector(b.wo, b.wi, here, beyond) == close_to(b.h, 1e-5));
      REQUIRE(length(b.wi) == close_to(1.0, 1e-6));
      // Snell: n_here (wo x h) = -n_beyond (wi x h).
      REQUIRE(here * cross(b.wo, b.h) == close_to(-beyond * cross(b.wi, b.h), 2e-6));
    });
}

TEST_CASE("half vector of transmission: it points up, and is null where the sum vanishes") {
  Pcg32 random(2);
  for (int i = 0; i < 10'000; ++i) {
    const vec3 wo = uniform_hemisphere(random.next_vec2());
    const vec3 wi = uniform_below(random.next_vec2());
    REQUIRE(transmission_half_vector(wo, wi, 1.0f, 1.5f).z >= 0.0f);
    REQUIRE(transmission_half_vector(wo, wi, 1.5f, 1.0f).z >= 0.0f);
  }
  const vec3 wo = slanting_at(0.5f);
  CHECK(transmission_half_vector(wo, -wo, 1.5f, 1.5f) == vec3(0.0f));
}

TEST_CASE("bend: nothing bends light to its own side, nor from the back of a facet") {
  const vec3 wo = slanting_at(0.7f);
  CHECK_FALSE(bend_between(wo, slanting_at(0.3f), 1.0f, 1.5f));
  CHECK_FALSE(bend_between(-wo, slanting_at(0.3f), 1.0f, 1.5f));
  // A ray that goes on flatter in the denser medium: no facet of the upper side does that.
  const vec3 flat(-0.99f, 0.0f, -std::sqrt(1 - 0.99f * 0.99f));
  CHECK_FALSE(bend_between({0, 0, 1}, flat, 1.0f, 1.5f));
  CHECK(bend_between({0, 0, 1}, {-0.3f, 0.0f, -std::sqrt(1 - 0.09f)}, 1.0f, 1.5f));
}

TEST_CASE("bend: the bent length is that of the sum, and its sign says which index is larger") {
  for (const auto& [here, beyond] : pairs)
    over_bends(here, beyond, [here = here, beyond = beyond](const Bent& b) {
      const auto bend = bend_between(b.wo, b.wi, here, beyond);
      REQUIRE(bend);
      const float signed_length = bent_length(*bend, here, beyond);
      REQUIRE(std::abs(signed_length) == Approx(length(here * b.wo + beyond * b.wi)).epsilon(1e-4));
      REQUIRE((signed_length > 0.0f) == (here > beyond));
    });
}

TEST_CASE("bend: a facet that turns a little turns its bent ray as the Jacobian says") {
  // Two small turns of h, at right angles, in double: the area that wi covers is the quotient of
  // the solid angles.
  for (const auto& [here, beyond] : pairs)
    over_bends(here, beyond, [here = here, beyond = beyond](const Bent& b) {
      const double eta = double{here} / double{beyond};
      const glm::dvec3 wo = glm::normalize(glm::dvec3(b.wo)), h = glm::normalize(glm::dvec3(b.h));
      if (1 - eta * eta * (1 - std::pow(glm::dot(wo, h), 2)) < 0.01) return;  // too near to total
      const glm::dvec3 s = glm::normalize(glm::cross(h, glm::dvec3(0.3, 0.4, 0.5)));
      const double step = 1e-5;
      const auto slope = [&](glm::dvec3 t) {
        return (bent(wo, glm::normalize(h + step * t), eta) -
                bent(wo, glm::normalize(h - step * t), eta)) /
               (2 * step);
      };
      const double area = glm::length(glm::cross(slope(s), slope(glm::cross(h, s))));
      const Bend bend{b.h, dot(b.wo, b.h), -dot(b.wi, b.h)};
      CAPTURE(here, beyond, b.wo, b.h, area);
      REQUIRE(facets_per_bent_ray(bend, here, beyond) == Approx(1 / area).epsilon(2e-4));
    });
}

TEST_CASE("bend: seen straight on, into 1.5, a ray turns by a third of its facet's turn") {
  // Small angles: the facet by a, Snell gives the ray a / 1.5 to the facet: turned by a / 3, in
  // both directions: 9 steradians of facets for each of rays. Out of glass: by a / 2, 4 for each.
  const Bend straight{{0, 0, 1}, 1.0f, 1.0f};
  CHECK(facets_per_bent_ray(straight, 1.0f, 1.5f) == close_to(9.0, 1e-5));
  CHECK(facets_per_bent_ray(straight, 1.5f, 1.0f) == close_to(4.0, 1e-5));
}
