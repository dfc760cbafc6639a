// Closest hits in the room, for the rays that paths ask for.
#include "tests/benchmarks/registered.hpp"
#include "tests/benchmarks/room_paths.hpp"

namespace lt::bench {
namespace {

template <class Scene>
void ask(benchmark::State& state, const Scene& scene, const std::vector<Ray>& rays, bool shade) {
  for (auto _ : state)
    for (const Ray& ray : rays) {
      const auto hit = closest_hit(scene, ray);
      if (hit && shade) benchmark::DoNotOptimize(surface_at(scene, ray, *hit));
      benchmark::DoNotOptimize(hit);
    }
  report(state, static_cast<double>(rays.size()), "queries");
}

void add(const std::string& name, bool is_packed, bool is_textured, bool shade) {
  add_benchmark(name, [=](benchmark::State& state) {
    const TexturedScene list = is_textured ? matt_room(256) : three_sphere_room_plain();
    const std::vector<Ray> rays = rays_of(list, cosine);
    if (is_packed) {
      ask(state, PackedScene(list), rays, shade);
    } else {
      ask(state, list, rays, shade);
    }
  });
}

}  // namespace

void add_rays() {
  add("closest hit/list", false, false, false);
  add("closest hit/packed", true, false, false);
  add("closest hit and surface/plain - packed", true, false, true);
  add("closest hit and surface/textured - packed", true, true, true);
}

}  // namespace lt::bench
