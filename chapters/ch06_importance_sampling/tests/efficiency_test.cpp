#include "ch06_importance_sampling/efficiency.hpp"

#include "common/testkit/catch.hpp"

using namespace lt;

TEST_CASE("efficiency: half the variance or half the time counts twice") {
  CHECK(efficiency({2, 3}) == Approx(1.0 / 6));
  CHECK(efficiency({1, 3}) == Approx(2 * efficiency({2, 3})));
  CHECK(efficiency({2, 1.5}) == Approx(2 * efficiency({2, 3})));
}

TEST_CASE("efficiency: it predicts the error after a time") {
  // Samples of 1 s with variance 4: after 100 s the mean has the variance 4 / 100.
  CHECK(1 / (efficiency({4, 1}) * 100) == Approx(0.04));
}

TEST_CASE("efficiency: pixel variances are those of the samples, colour by colour") {
  // A uniform number has the variance 1/12, three times that number 9/12, a constant none.
  const auto estimate = [](const Ray&, Pcg32& random) {
    const float u = random.next_float();
    return Rgb(u, 3.0f * u, 0.25f);
  };
  const Image variances = pixel_variances({}, estimate, 6, 5, {.last = 20'000});
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 6; ++x) {
      // The variance's own standard error is 0.9 / sqrt(n) of it: 0.6 %.
      REQUIRE(variances.at(x, y).r == Approx(1.0 / 12).epsilon(0.04));
      REQUIRE(variances.at(x, y).g == Approx(9.0 / 12).epsilon(0.04));
      REQUIRE(variances.at(x, y).b == 0.0f);
    }
  CHECK(mean_of(variances) == Approx(10.0 / 36).epsilon(0.01));
}

TEST_CASE("efficiency: any number of threads and any tiles find the same variances") {
  const auto estimate = [](const Ray& ray, Pcg32& random) {
    return Rgb(ray.direction.x + random.next_float());
  };
  const auto found = [&](int threads, int tile_size) {
    return mean_of(pixel_variances({}, estimate, 33, 17,
                                   {.last = 8, .threads = threads, .tile_size = tile_size}));
  };
  CHECK(found(1, 32) == found(3, 8));
}

TEST_CASE("efficiency: work that takes longer has the same variance and less efficiency") {
  const auto after = [](int turns) {
    return [turns](const Ray&, Pcg32& random) {
      Rgb sample(random.next_float());
      for (int i = 0; i < turns; ++i)
        sample = sample * 0.5f + 0.5f * sample;
      return sample;
    };
  };
  const SampleCost quick = measure_cost({}, after(0), 32, 32, {.last = 64, .threads = 1});
  const SampleCost slow = measure_cost({}, after(2000), 32, 32, {.last = 64, .threads = 1});
  CHECK(quick.variance == slow.variance);
  CHECK(slow.seconds > 3 * quick.seconds);
  CHECK(efficiency(slow) < efficiency(quick));
}
