// What the integrator asks for, and that it asks for nothing else.
#include <functional>

#include "ch05_rendering_equation/furnace.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

// Each of these lacks one thing. Declared only: nobody calls them.
namespace lt::refused {

struct NoHit {};
Surface surface_at(const NoHit&, const Ray&, Hit);
Rgb background(const NoHit&, vec3);

struct NoSurface {};
std::optional<Hit> closest_hit(const NoSurface&, const Ray&);
Rgb background(const NoSurface&, vec3);

struct NoBackground {};
std::optional<Hit> closest_hit(const NoBackground&, const Ray&);
Surface surface_at(const NoBackground&, const Ray&, Hit);

struct DistanceOnly {};
std::optional<float> closest_hit(const DistanceOnly&, const Ray&);
Surface surface_at(const DistanceOnly&, const Ray&, Hit);
Rgb background(const DistanceOnly&, vec3);

}  // namespace lt::refused

namespace {

using namespace lt::refused;

static_assert(Traceable<TexturedScene>);
static_assert(Traceable<HollowSphere>);
static_assert(Traceable<lt::testing::TwoPlates>);
static_assert(Traceable<lt::testing::UnderSky>);
static_assert(!Traceable<NoHit>);
static_assert(!Traceable<NoSurface>);
static_assert(!Traceable<NoBackground>);
static_assert(!Traceable<DistanceOnly>);
static_assert(!Traceable<Scene>);  // geometry alone has no looks
static_assert(!Traceable<int>);

struct NoEval {
  std::optional<BsdfSample> sample(vec3, vec3) const;
  float pdf(vec3, vec3) const;
};
struct NoSample {
  Rgb eval(vec3, vec3) const;
  float pdf(vec3, vec3) const;
};
struct NoPdf {
  Rgb eval(vec3, vec3) const;
  std::optional<BsdfSample> sample(vec3, vec3) const;
};
struct NeverFails : NoSample {
  BsdfSample sample(vec3, vec3) const;
};
struct Changing {  // asked of a BSDF that may not change
  Rgb eval(vec3, vec3);
  std::optional<BsdfSample> sample(vec3, vec3);
  float pdf(vec3, vec3);
};

static_assert(Bsdf<UniformLambert>);
static_assert(Bsdf<lt::testing::StraightUp>);
static_assert(!Bsdf<NoEval>);
static_assert(!Bsdf<NoSample>);
static_assert(!Bsdf<NoPdf>);
static_assert(!Bsdf<NeverFails>);
static_assert(!Bsdf<Changing>);

static_assert(Scattering<decltype(uniform_lambert_at)>);
static_assert(Scattering<decltype(lt::testing::soot_at)>);
static_assert(!Scattering<decltype(emitted)>);  // a colour is no BSDF
static_assert(!Scattering<UniformLambert>);     // a BSDF is not asked for one

static_assert(RadianceEstimator<std::function<Rgb(const Ray&, Pcg32&)>>);
static_assert(!RadianceEstimator<Rgb (*)(const Ray&)>);            // where is the chance?
static_assert(!RadianceEstimator<float (*)(const Ray&, Pcg32&)>);  // in which colour?

}  // namespace

TEST_CASE("traceable: a scene without shapes is traced by the same code") {
  const lt::testing::TwoPlates plates{lt::testing::matt(Rgb(0.5f), Rgb(1.0f)),
                                      lt::testing::matt(Rgb(0.5f), Rgb(1.0f))};
  const Ray ray{{0.0f, 0.5f, 0.0f}, normalize(vec3(1, 2, 3))};
  for (int depth = 0; depth <= 4; ++depth) {
    const RunningMean mean =
        lt::testing::many(ray, 100'000, lt::testing::uniform_estimator(plates, depth));
    CHECK(z_test(mean, furnace_radiance(1, 0.5, depth)).agrees());
  }
}

TEST_CASE("traceable: the render loop takes any estimator and any scene") {
  const lt::testing::TwoPlates plates{lt::testing::matt(Rgb(0.5f), Rgb(1.0f)),
                                      lt::testing::matt(Rgb(0.5f), Rgb(1.0f))};
  Camera camera;
  camera.position.y = 0.5f;
  const std::atomic<bool> cancel{false};
  Film film(16, 12);
  render(film, camera, lt::testing::uniform_estimator(plates, 0), {.last = 4}, cancel);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 16; ++x)
      REQUIRE(film.at(x, y).sum == glm::dvec3(4.0));
}
