#include "ch06_importance_sampling/sampled_room.hpp"

#include "ch05_rendering_equation/render.hpp"
#include "ch06_importance_sampling/efficiency.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const std::atomic<bool> never{false};
constexpr int width = 40, height = 32, block = 8;

const SampledRoom& the_room() {
  static const SampledRoom made(16);
  return made;
}

// Mean and standard error of each block of 8 x 8 pixels, from independent pictures.
std::vector<RunningMean> blocks(const SampledRoomOptions& options, int pictures, int seed) {
  std::vector<RunningMean> means(width / block * height / block);
  const AnyEstimator estimate = estimator_for(the_room(), options);
  for (int i = 0; i < pictures; ++i) {
    Film film(width, height);
    render(film, room_camera_far(), estimate,
           {.last = 8, .seed = static_cast<std::uint64_t>(seed + i)}, never);
    const Image image = developed(film);
    std::vector<double> sums(means.size());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        sums[static_cast<std::size_t>(y / block * (width / block) + x / block)] += image.at(x, y).g;
    for (std::size_t j = 0; j < means.size(); ++j)
      means[j].add(sums[j] / (block * block));
  }
  return means;
}

// z of each block's difference.
std::vector<double> z_of(const std::vector<RunningMean>& a, const std::vector<RunningMean>& b) {
  std::vector<double> z;
  for (std::size_t i = 0; i < a.size(); ++i)
    z.push_back((a[i].mean() - b[i].mean()) /
                std::hypot(a[i].standard_error(), b[i].standard_error()));
  return z;
}

double largest(const std::vector<double>& z) {
  double found = 0;
  for (const double one : z)
    found = std::max(found, std::abs(one));
  return found;
}

// With 40 pictures of 8 samples each.
std::vector<RunningMean> many(const std::string& sampler, const std::string& wrong = "none") {
  return blocks({sampler, wrong, "packed", 8}, 40, sampler == "uniform" ? 1 : 1001);
}

}  // namespace

TEST_CASE("room: both samplers see the same room, block by block") {
  const auto uniform = many("uniform");
  const auto cosine = many("cosine");
  const std::vector<double> z = z_of(uniform, cosine);
  CHECK(largest(z) < 6);
  double squares = 0;  // of 20 nearly normal numbers: chi-square with 20 degrees of freedom
  for (const double one : z)
    squares += one * one;
  CHECK(chi_square_tail(squares, static_cast<int>(z.size())) > 1e-6);
  // And well enough measured: the mean of all blocks to 2 %.
  double mean = 0, square = 0;
  for (const RunningMean& one : cosine) {
    mean += one.mean();
    square += std::pow(one.standard_error(), 2);
  }
  CHECK(std::sqrt(square) < 0.02 * mean);
}

TEST_CASE("room: the old density and the missing root show another room") {
  const auto right = many("cosine");
  CHECK(largest(z_of(many("uniform", "density"), right)) > 6);
  CHECK(largest(z_of(many("uniform", "root"), right)) > 6);
}

TEST_CASE("room: errors that cancel show the right room, until somebody else asks the surface") {
  const auto right = many("cosine");
  const auto own = many("cosine", "both");
  for (std::size_t i = 0; i < right.size(); ++i)
    CHECK(own[i].mean() == right[i].mean());  // the same picture, bit for bit
  CHECK(largest(z_of(many("uniform", "both"), right)) > 6);
}

TEST_CASE("room: the cosine's sampler is less noisy and both layouts give the same picture") {
  const auto variance = [](const SampledRoomOptions& options) {
    return mean_of(pixel_variances(room_camera_far(), estimator_for(the_room(), options), 40, 32,
                                   {.last = 128}));
  };
  const double uniform = variance({.sampler = "uniform"});
  const double cosine = variance({.sampler = "cosine"});
  CHECK(cosine < 0.9 * uniform);
  CHECK(variance({.sampler = "cosine", .layout = "list"}) == cosine);
  CHECK(variance({.sampler = "uniform", .layout = "list"}) == uniform);
}

TEST_CASE("room: no sample of either sampler is negative or infinite or NaN") {
  for (const char* sampler : {"uniform", "cosine"}) {
    Film film(90, 72);
    render(film, room_camera_near(), estimator_for(the_room(), {.sampler = sampler}), {.last = 16},
           never);
    CHECK(summary(film).bad == 0);
  }
}
