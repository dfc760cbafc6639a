#include "ch04_monte_carlo/views.hpp"

#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

PhotonOptions small_photons(int samples) {
  PhotonOptions options;
  options.width = 60;
  options.height = 48;
  options.samples_per_pixel = samples;
  return options;
}

bool is_same(const Image& a, const Image& b) {
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a.at(x, y) != b.at(x, y)) return false;
  return true;
}

// The errors of the pictures' greens, against what is counted: light, at most 1.
RunningMean errors_of(const PhotonOptions& options) {
  const Image image = photon_picture(options);
  const Image light = evening_picture(options.width, options.height);
  RunningMean errors;
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x)
      errors.add(image.at(x, y).g - std::min(light.at(x, y).g, 1.0f));
  return errors;
}

}  // namespace

TEST_CASE("photons: their mean is the light, in every color") {
  const Rgb light(0.75f, 0.3f, 0.01f);
  Pcg32 random(1);
  RunningMean red, green, blue;
  for (int i = 0; i < 1'000'000; ++i) {
    const Rgb sample = photon(light, random.next_float());
    red.add(sample.r);
    green.add(sample.g);
    blue.add(sample.b);
  }
  CHECK(z_test(red, light.r).agrees());
  CHECK(z_test(green, light.g).agrees());
  CHECK(z_test(blue, light.b).agrees());
  CHECK(photon(Rgb(0.0f), 0.0f) == Rgb(0.0f));          // no light, no photon
  CHECK(photon(Rgb(1.0f), 1 - 0x1p-24f) == Rgb(1.0f));  // white, always one
}

TEST_CASE(
    "photons: the picture is right in the mean, and sixteen times the samples cost a quarter "
    "of the error") {
  const RunningMean few = errors_of(small_photons(16));
  const RunningMean many = errors_of(small_photons(256));
  CHECK(z_test(few, 0).agrees());
  CHECK(z_test(many, 0).agrees());
  CHECK(few.variance() / many.variance() == Approx(16).epsilon(0.2));
}

TEST_CASE("photons: one in each part leaves less than one part's error") {
  PhotonOptions options = small_photons(16);
  options.is_stratified = true;
  const RunningMean errors = errors_of(options);
  CHECK(z_test(errors, 0).agrees());
  // A part that holds the light at share s of it has variance s (1 - s) / 16^2, at most 1/4.
  CHECK(errors.variance() < 0.25 / 256);
  CHECK(errors.variance() < errors_of(small_photons(16)).variance() / 4);

  RunningMean pixels;  // all of the same light, which lies inside a part, 0.3 = 4.8 / 16
  for (int x = 0; x < 10'000; ++x)
    pixels.add(photon_pixel(options, Rgb(0.3f), x, 0, 16).g);
  CHECK(z_test(pixels, 0.3f).agrees());
  CHECK(pixels.variance() == Approx(0.8 * 0.2 / 256).epsilon(0.1));
}

TEST_CASE("photons: the same picture for any number of threads, another for another seed") {
  PhotonOptions options = small_photons(4);
  options.threads = 1;
  const Image one = photon_picture(options);
  for (const int threads : {2, 7}) {
    options.threads = threads;
    CHECK(is_same(photon_picture(options), one));
  }
  options.seed = 2;
  CHECK_FALSE(is_same(photon_picture(options), one));
}

TEST_CASE("photons: the strip has 1, 4, 16, 64 and 256 samples") {
  CHECK(samples_of_band(0, 100) == 1);
  CHECK(samples_of_band(19, 100) == 1);
  CHECK(samples_of_band(20, 100) == 4);
  CHECK(samples_of_band(59, 100) == 16);
  CHECK(samples_of_band(60, 100) == 64);
  CHECK(samples_of_band(99, 100) == 256);
}

TEST_CASE("darts: one in every cell if stratified, gold on the disk and blue beside it") {
  Pcg32 random(1);
  std::vector<int> counts(100);
  for (const vec2 dart : throw_stratified_darts(10, random)) {
    const ivec2 cell(5.0f * (dart + 1.0f));
    ++counts[static_cast<std::size_t>(10 * cell.y + cell.x)];
  }
  CHECK(counts == std::vector<int>(100, 1));

  const Image image = dart_picture({vec2(0.0f), vec2(0.9f, 0.9f)}, 101, 101);
  const Rgb on_disk = image.at(50, 50);
  const Rgb beside = image.at(50 + 44, 50 - 44);  // 0.9 * 0.97 * 50.5 pixels right and up
  CHECK((on_disk.r > 0.5f && on_disk.b < 0.3f));
  CHECK((beside.b > 0.5f && beside.r < 0.3f));
}

TEST_CASE("histogram: shares by width, and what lies outside counts as a sample") {
  const Series steps = histogram({0.1, 0.2, 0.6, 7.0}, 0, 1, 2);
  CHECK(steps.x == std::vector<double>{0, 0.5, 0.5, 1});
  CHECK(steps.y == std::vector<double>{1, 1, 0.5, 0.5});  // 2/4 and 1/4, by 1/2
}

TEST_CASE("views: every view is finite and not negative, every plot has a description") {
  ChanceOptions options;
  options.photons = small_photons(2);
  for (const std::string& view : chance_views()) {
    options.view = view;
    const Image image = make_picture(options);
    bool is_light = true;
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 60; ++x)
        for (int c = 0; c < 3; ++c)
          is_light = is_light && std::isfinite(image.at(x, y)[c]) && image.at(x, y)[c] >= 0.0f;
    INFO(view);
    CHECK(is_light);
  }
  for (const std::string& name : chance_plots()) {
    const Plot plot = make_plot(name, 1000, 1);
    INFO(name);
    CHECK(plot.series.size() >= 2);
    CHECK_FALSE(plot.description.empty());
  }
}

TEST_CASE("views: the printed tables say what is known") {
  CHECK(make_table("integrals", 1000, 1).find("2.666667") != std::string::npos);
  CHECK(make_table("errors", 1000, 1).find("16384") != std::string::npos);
  CHECK(make_table("mistakes", 1000, 1).find("1.00000000") != std::string::npos);
}
