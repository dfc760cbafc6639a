#include "common/testkit/exercise.hpp"

#include <cmath>
#include <cstdlib>

#include "common/error.hpp"
#include "common/testkit/statistics.hpp"

TEST_CASE("test random: the generator is SplitMix64") {
  // The first five outputs for seed 1234567, as published with the algorithm's test vectors.
  lt::TestRandom random(1234567);
  CHECK(random.next_bits() == 6457827717110365317u);
  CHECK(random.next_bits() == 3203168211198807973u);
  CHECK(random.next_bits() == 9817491932198370423u);
  CHECK(random.next_bits() == 4593380528125082431u);
  CHECK(random.next_bits() == 16408922859458223821u);
}

TEST_CASE("test random: uniform stays below its upper end") {
  lt::TestRandom random(1);
  const double high = std::nextafter(1.0, 2.0);  // the only numbers in [1, high) are 1
  for (int i = 0; i < 1000; ++i)
    REQUIRE(random.uniform(1, high) == 1.0);
  std::vector<double> samples;
  for (int i = 0; i < 100'000; ++i)
    samples.push_back(random.uniform(-3, 5));
  const auto test = lt::kolmogorov_smirnov(samples, [](double x) { return (x + 3) / 8; });
  CHECK(test.p_value > 1e-6);
}

TEST_CASE("test random: directions are unit and fill the sphere evenly") {
  // Archimedes: each coordinate of a uniform direction is uniform in [-1, 1].
  lt::TestRandom random(2);
  std::vector<double> coordinates[3];
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 d = random.direction();
    REQUIRE(std::abs(glm::length(d) - 1) < 1e-12);
    for (int c = 0; c < 3; ++c)
      coordinates[c].push_back(d[c]);
  }
  for (const auto& samples : coordinates)
    CHECK(lt::kolmogorov_smirnov(samples, [](double x) { return (x + 1) / 2; }).p_value > 1e-6);
}

#ifndef _WIN32  // it has no setenv
TEST_CASE("seeds: one normally, as many as the fairness check asks for, never by mistake") {
  const char* set = std::getenv("LT_FAIR_SEEDS");
  const std::string before = set ? set : "";
  unsetenv("LT_FAIR_SEEDS");
  CHECK(lt::seeds() == std::vector<std::uint64_t>{1});
  setenv("LT_FAIR_SEEDS", "3", 1);
  CHECK(lt::seeds() == std::vector<std::uint64_t>{1, 2, 3});
  for (const char* wrong : {"", "0", "-1", "many", "3x", "1e9", "99999999999999999999"}) {
    setenv("LT_FAIR_SEEDS", wrong, 1);
    CHECK_THROWS_AS(lt::seeds(), lt::InputError);
  }
  unsetenv("LT_FAIR_SEEDS");
  if (!before.empty()) setenv("LT_FAIR_SEEDS", before.c_str(), 1);
}
#endif

TEST_CASE("diagnose: right code passes and prints nothing") {
  lt::diagnose(true, "some-tag", "nothing wrong");
}
