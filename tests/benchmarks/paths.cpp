// Camera paths through the room at depth 8, and pictures by one and two threads.
#include "ch11_refraction/glass_scenes.hpp"
#include "ch11_refraction/glass_tables.hpp"
#include "tests/benchmarks/registered.hpp"
#include "tests/benchmarks/room_paths.hpp"

namespace lt::bench {
namespace {

template <class Scene, class Model>
void trace(benchmark::State& state, const Scene& scene, const TexturedScene& list,
           const Model& bsdf_at) {
  Film film(width, height);
  for (auto _ : state)
    take_paths(film, scene, bsdf_at);
  report(state, paths, "paths");
  const auto queries = static_cast<double>(rays_of(list, bsdf_at).size());
  state.counters["queries"] = benchmark::Counter(queries * static_cast<double>(state.iterations()),
                                                 benchmark::Counter::kIsRate);
}

template <class Model>
void add(const std::string& name, bool is_packed, int texels, const Model& bsdf_at) {
  add_benchmark(name, [=](benchmark::State& state) {
    const TexturedScene list = texels > 0 ? matt_room(texels) : three_sphere_room_plain();
    if (is_packed) {
      trace(state, PackedScene(list), list, bsdf_at);
    } else {
      trace(state, list, list, bsdf_at);
    }
  });
}

// The complete room at depth 12. Counting costs nothing that could be measured.
void add_complete(const std::string& name, int texels) {
  const auto measure = [=](benchmark::State& state) {
    const TexturedScene list = texels > 0 ? complete_room(texels) : three_sphere_room_plain();
    const PackedScene packed(list);
    const CountingScene counting{packed};
    const auto estimate = [&](const Ray& ray, Pcg32& random) {
      const auto bsdf_at = [](const Surface& surface) { return complete_bsdf_at(surface); };
      return radiance_through_media(counting, bsdf_at, ray, 12, random);
    };
    const std::atomic<bool> never{false};
    Film film(width, height);
    for (auto _ : state)
      render(film, room_camera_far(), estimate, {.threads = 1}, never);
    report(state, paths, "paths");
    state.counters["queries"] =
        benchmark::Counter(static_cast<double>(counting.queries), benchmark::Counter::kIsRate);
  };
  add_benchmark(name, measure);
}

void add_picture(const std::string& name, int threads) {
  const auto measure = [=](benchmark::State& state) {
    const TexturedScene list = three_sphere_room_plain();
    const PackedScene packed(list);
    const auto estimate = [&](const Ray& ray, Pcg32& random) {
      return radiance_recursive(packed, cosine, ray, depth, random);
    };
    const std::atomic<bool> never{false};
    Film film(4 * width, 4 * height);
    for (auto _ : state)
      render(film, room_camera_far(), estimate, {.last = 4, .threads = threads}, never);
    report(state, 4 * 16 * paths, "paths");
  };
  add_benchmark(name, measure)->UseRealTime();
}

}  // namespace

void add_paths() {
  add("paths/plain - uniform - list", false, 0, uniform);
  add("paths/plain - cosine - list", false, 0, cosine);
  add("paths/plain - cosine - packed", true, 0, cosine);
  add("paths/textured 128 - cosine - list", false, 128, cosine);
  add("paths/textured 128 - cosine - packed", true, 128, cosine);
  add("paths/textured 256 - cosine - packed", true, 256, cosine);
  add_complete("paths/complete, plain", 0);
  add_complete("paths/complete, textured 128", 128);
  add_complete("paths/complete, textured 256", 256);
  add_picture("picture by the clock/1 thread", 1);
  add_picture("picture by the clock/2 threads", 2);
}

}  // namespace lt::bench
