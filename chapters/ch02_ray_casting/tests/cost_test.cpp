#include "ch02_ray_casting/cost_plot.hpp"

#include "common/testkit/catch.hpp"

using namespace lt;

TEST_CASE("cost: the fit finds a law that the times follow") {
  for (const double power : {1.0, 2.0}) {
    std::vector<Cost> costs;
    for (const double n : {1.0, 4.0, 16.0, 256.0})
      costs.push_back({n, 12.0 + 3.5 * std::pow(n, power)});
    const CostLaw law = fit(costs, power);
    CHECK(law.start == Approx(12.0));
    CHECK(law.slope == Approx(3.5));
  }
}

TEST_CASE("cost: no law nearby has smaller relative errors") {
  const std::vector<Cost> costs{{1, 10}, {2, 14}, {8, 30}, {64, 150}, {512, 1500}};
  const auto badness = [&](const CostLaw& law) {
    double sum = 0;
    for (const Cost& cost : costs)
      sum += std::pow((law.start + law.slope * cost.spheres) / cost.nanoseconds - 1, 2);
    return sum;
  };
  const CostLaw best = fit(costs, 1.0);
  for (const double change : {0.99, 1.01}) {
    CHECK(badness(best) < badness({best.start * change, best.slope}));
    CHECK(badness(best) < badness({best.start, best.slope * change}));
    CHECK(badness(best) < badness({best.start * change, best.slope / change}));
  }
}

TEST_CASE("cost: directions of the fan are unit and balanced") {
  vec3 sum(0.0f);
  for (const Ray& ray : fan(4096)) {
    REQUIRE(length(ray.direction) == Approx(1).epsilon(1e-5));
    sum += ray.direction;
  }
  CHECK(length(sum) / 4096 < 0.01f);
}

TEST_CASE("cost: the plot shows both searches with their measured points and fitted laws") {
  const Plot plot = cost_plot(stored_costs());
  REQUIRE(plot.series.size() == 4);
  for (const Series& series : plot.series) {
    CHECK(series.x.size() >= 8);
    CHECK(series.x.size() == series.y.size());
  }
  CHECK(plot.log_x);
  CHECK(plot.log_y);
  CHECK_FALSE(plot.description.empty());
}

TEST_CASE("cost: measuring gives a time for every scene and they grow") {
  const Scene few = scattered_spheres(1);
  const Scene many = scattered_spheres(2000);
  REQUIRE(many.spheres.size() == 2000);
  const auto time = [](const Scene& scene, int count) {
    return time_per_ray(fan(512), count, [&](const Ray& ray) { return closest_hit(scene, ray); });
  };
  CHECK(time(many, 2'000) > 5 * time(few, 20'000));
}
