// What a surface does: eval, sample and pdf of each kind.
#include <string>
#include <vector>

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch06_importance_sampling/cosine_lambert.hpp"
#include "ch07_fresnel/glass.hpp"
#include "ch07_fresnel/mirror.hpp"
#include "ch07_fresnel/schlick.hpp"
#include "ch08_microfacets/microfacet.hpp"
#include "ch09_metal_and_plastic/all_normals.hpp"
#include "ch09_metal_and_plastic/metal_and_plastic.hpp"
#include "ch10_dielectric/coated.hpp"
#include "ch11_refraction/rough_glass.hpp"
#include "tests/benchmarks/registered.hpp"

namespace lt::bench {
namespace {

constexpr std::size_t count = 1024;

// Directions to look from, numbers to sample with, and directions to ask for.
struct Questions {
  std::vector<vec3> wo, wi, u;

  Questions() {
    Pcg32 random(1);
    for (std::size_t i = 0; i < count; ++i) {
      wo.push_back(cosine_hemisphere(random.next_vec2()));
      wi.push_back(cosine_hemisphere(random.next_vec2()));
      u.push_back(random.next_vec3());
    }
  }
};

// One turn is 1024 calls: a single one is shorter than the loop around it.
template <class Call>
void add(const std::string& name, const char* unit, const Call& call) {
  const auto measure = [=](benchmark::State& state) {
    const Questions ask;
    for (auto _ : state)
      for (std::size_t i = 0; i < count; ++i)
        benchmark::DoNotOptimize(call(ask, i));
    report(state, count, unit);
  };
  add_benchmark(name, measure);
}

template <Bsdf AnyBsdf>
void add_bsdf(const std::string& name, const AnyBsdf& bsdf) {
  add(name + "/eval", "values",
      [=](const Questions& ask, std::size_t i) { return bsdf.eval(ask.wo[i], ask.wi[i]); });
  add(name + "/sample", "directions",
      [=](const Questions& ask, std::size_t i) { return bsdf.sample(ask.wo[i], ask.u[i]); });
  add(name + "/pdf", "densities",
      [=](const Questions& ask, std::size_t i) { return bsdf.pdf(ask.wo[i], ask.wi[i]); });
}

// The same with light from both sides.
template <Bsdf AnyBsdf>
void add_interface(const std::string& name, const AnyBsdf& bsdf) {
  const auto from_either_side = [](const Questions& ask, std::size_t i) {
    return ask.wi[i] * vec3(1.0f, 1.0f, i % 2 ? 1.0f : -1.0f);
  };
  add(name + "/eval", "values", [=](const Questions& ask, std::size_t i) {
    return bsdf.eval(ask.wo[i], from_either_side(ask, i));
  });
  add(name + "/sample", "directions",
      [=](const Questions& ask, std::size_t i) { return bsdf.sample(ask.wo[i], ask.u[i]); });
  add(name + "/pdf", "densities", [=](const Questions& ask, std::size_t i) {
    return bsdf.pdf(ask.wo[i], from_either_side(ask, i));
  });
}

}  // namespace

void add_bsdfs() {
  add("Fresnel/Schlick", "shares",
      [](const Questions& ask, std::size_t i) { return schlick(ask.wo[i].z, 0.04f); });
  add("Fresnel/dielectric", "shares", [](const Questions& ask, std::size_t i) {
    return fresnel_dielectric(ask.wo[i].z, 1.0f, 1.5f);
  });
  add("Fresnel/conductor, three channels", "colours", [](const Questions& ask, std::size_t i) {
    return fresnel_conductor(ask.wo[i].z, index_of_air, gold.eta, gold.k);
  });
  add_bsdf("matt", CosineLambert{Rgb(0.5f)});
  add_bsdf("mirror", Mirror{gold});
  add_bsdf("clear glass", Glass{1.0f, 1.5f});
  const Ggx ggx{0.3f};
  add_bsdf("rough gold, by the cosine", MicrofacetReflection{ggx, ConductorFresnel{gold}});
  add_bsdf("rough gold, all normals", MetalReflection<AllNormals>{ggx, {gold}});
  add_bsdf("rough gold, visible normals", MetalReflection<>{ggx, {gold}});
  add_bsdf("plastic", PlasticReflection<>{ggx, {{index_of_air, 1.5f}, Rgb(0.5f)}});
  const CoatFresnel coat{1.5f};
  const Rgb grey(0.5f);
  static const SpecularAlbedo table(ggx.alpha, coat.ior);
  add_bsdf("coated, reciprocal base", CoatedDiffuse<ReciprocalBase>{{ggx, coat}, {grey, coat}});
  add_bsdf("coated, conserving base",
           CoatedDiffuse<ConservingBase>{{ggx, coat}, {grey, 1.0f, table}});
  add_bsdf("polished coat", PolishedDiffuse<ReciprocalBase>{coat, {grey, coat}});
  add_interface("rough glass, into", RoughGlass<>{ggx, index_of_air, 1.5f});
  add_interface("rough glass, out of", RoughGlass<>{ggx, 1.5f, index_of_air});
}

}  // namespace lt::bench
