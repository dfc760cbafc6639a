// Random numbers, and directions made from them.
#include "ch04_monte_carlo/streams.hpp"
#include "ch05_rendering_equation/uniform_hemisphere.hpp"
#include "ch06_importance_sampling/cosine_hemisphere.hpp"
#include "tests/benchmarks/registered.hpp"

namespace lt::bench {
namespace {

// One turn is 1024 of them: a single one is shorter than the loop around it.
template <class Make>
void add(const std::string& name, const char* unit, const Make& make) {
  const auto measure = [make, unit](benchmark::State& state) {
    constexpr int count = 1024;
    Pcg32 random(1);
    for (auto _ : state)
      for (int i = 0; i < count; ++i)
        benchmark::DoNotOptimize(make(random, i));
    report(state, count, unit);
  };
  add_benchmark(name, measure);
}

}  // namespace

void add_numbers() {
  add("random/bits", "numbers", [](Pcg32& random, int) { return random.next_bits(); });
  add("random/float", "numbers", [](Pcg32& random, int) { return random.next_float(); });
  add("random/stream for a sample", "streams",
      [](Pcg32&, int i) { return stream_for(1, i, 2, 3).next_bits(); });
  add("sampler/uniform hemisphere", "directions",
      [](Pcg32& random, int) { return uniform_hemisphere(random.next_vec2()); });
  add("sampler/cosine hemisphere", "directions",
      [](Pcg32& random, int) { return cosine_hemisphere(random.next_vec2()); });
}

}  // namespace lt::bench
