// Light among rough surfaces, where it is known.
#include "ch05_rendering_equation/furnace.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "ch08_microfacets/albedo.hpp"
#include "ch09_metal_and_plastic/all_normals.hpp"
#include "ch09_metal_and_plastic/rough.hpp"
#include "ch09_metal_and_plastic/studio.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

Material metal_with(float roughness) {
  return {.tint = {0.9f, 0.8f, 0.7f},
          .roughness = roughness,
          .ior = 0.277f,
          .extinction = 2.92f,
          .type = MaterialType::metal};
}

template <class Normals = VisibleNormals>
auto estimator_on(const Traceable auto& scene, int depth) {
  return [&scene, depth](const Ray& ray, Pcg32& random) {
    const auto bsdf_at = [](const Surface& surface) { return rough_bsdf_at<Normals>(surface); };
    return radiance_recursive(scene, bsdf_at, ray, depth, random);
  };
}

// A function of the cosine, known at 65 places.
struct Table {
  std::vector<double> values;

  explicit Table(const std::function<double(float)>& f) {
    for (int i = 0; i <= 64; ++i)
      values.push_back(f(std::max(1e-3f, static_cast<float>(i) / 64)));
  }
  double at(float mu) const {
    const float place = mu * 64;
    const auto i = std::min(static_cast<std::size_t>(place), std::size_t{63});
    return glm::mix(values[i], values[i + 1], double{place} - static_cast<double>(i));
  }
};

// Green radiance in a glowing sphere of this metal after at most `depth` events, by quadrature:
// L_K(mu) = 1 + integral of f mu_i L_{K-1}(mu_i). A chord of a sphere meets it at both ends at the
// same angle, so that mu is all that one has to know.
double furnace_by_quadrature(const Material& wall, float mu, int depth) {
  const auto metal = metal_of(wall);
  const auto next = [&](const Table& last, float cosine) {
    const auto value = [&](vec3 wo, vec3 wi) {
      return metal.eval(wo, wi) * static_cast<float>(last.at(wi.z));
    };
    return 1 + albedo(value, metal.ggx.alpha, at_cosine(cosine), 200);
  };
  Table radiance([](float) { return 1.0; });
  for (int k = 1; k < depth; ++k)
    radiance = Table([&, last = radiance](float cosine) { return next(last, cosine); });
  return next(radiance, mu);
}

// In the hollow sphere: from a point on the x axis along z, so that the wall is met at this cosine.
Ray at_wall_cosine(float mu) {
  return {{std::sqrt(1.0f - mu * mu), 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
}

}  // namespace

TEST_CASE("rough ball: under an even sky it shows its albedo") {
  for (const float roughness : {0.1f, 0.4f, 1.0f}) {
    UnderSky open{TexturedScene(Scene{{{vec3(0.0f), 1.0f}}, {}, {}}), Rgb(1.5f)};
    open.scene.looks[0].material = metal_with(roughness);
    const auto metal = metal_of(metal_with(roughness));
    const auto value = [&](vec3 wo, vec3 wi) { return metal.eval(wo, wi); };
    for (const float sine : {0.0f, 0.6f, 0.95f}) {
      const Ray ray{{sine, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
      const double expected =
          1.5 * albedo(value, roughness, at_cosine(std::sqrt(1.0f - sine * sine)), 400);
      CAPTURE(roughness, sine, expected);
      CHECK(z_test(many(ray, 100'000, estimator_on(open, 3)), expected).agrees(1e-3));
      CHECK(z_test(many(ray, 100'000, estimator_on<AllNormals>(open, 3)), expected).agrees(1e-3));
    }
  }
}

TEST_CASE("rough furnace: a glowing metal sphere is as bright as quadrature says, at any depth") {
  for (const float roughness : {0.2f, 0.7f}) {
    HollowSphere furnace{metal_with(roughness)};
    furnace.material.emission = Rgb(1.0f);
    for (const float mu : {0.9f, 0.4f})
      for (const int depth : {1, 2, 4}) {
        const double expected = furnace_by_quadrature(furnace.material, mu, depth);
        CAPTURE(roughness, mu, depth, expected);
        CHECK(z_test(many(at_wall_cosine(mu), 50'000, estimator_on(furnace, depth)), expected)
                  .agrees(1e-3));
      }
  }
}

TEST_CASE("rough ball: under a sky with a lamp it agrees with chapter 8's, asked by cosine") {
  const Studio studio = row_of(metal_with(0.0f));
  const auto old_at = [](const Surface& surface) {
    const auto metal = metal_of(surface.material);
    return MicrofacetReflection<ConductorFresnel>{metal.ggx, metal.fresnel};
  };
  const auto old = [&](const Ray& ray, Pcg32& random) {
    return radiance_recursive(studio, old_at, ray, 2, random);
  };
  for (const float x : {-2.9f, -2.1f, -1.4f}) {  // on the ball of alpha 0.1
    const Ray ray{{x, 0.3f, -9.0f}, {0.0f, 0.0f, 1.0f}};
    const RunningMean a = many(ray, 200'000, old);
    for (const RunningMean& b : {many(ray, 50'000, estimator_on(studio, 2)),
                                 many(ray, 50'000, estimator_on<AllNormals>(studio, 2))}) {
      CAPTURE(x, a.mean(), b.mean());
      CHECK(std::abs(a.mean() - b.mean()) < 6 * std::hypot(a.standard_error(), b.standard_error()));
    }
  }
}
