#include "ch05_rendering_equation/film.hpp"

#include <limits>

#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

std::string complaint(const Film& film) {
  try {
    require_good_samples(film);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("film: a pixel is the mean of its samples and black without any") {
  Film film(3, 2);
  film.add(2, 1, {1.0f, 2.0f, 3.0f});
  film.add(2, 1, {2.0f, 4.0f, 8.0f});
  const Image image = developed(film);
  CHECK(image.width() == 3);
  CHECK(image.height() == 2);
  CHECK(image.at(2, 1) == Rgb(1.5f, 3.0f, 5.5f));
  CHECK(image.at(1, 1) == Rgb(0.0f));
  CHECK(image.at(2, 0) == Rgb(0.0f));
}

TEST_CASE("film: small samples are not lost beside a large one") {
  // In float, 2^24 + 1 = 2^24: a million further ones would leave no trace.
  Film film(1, 1);
  film.add(0, 0, Rgb(0x1p24f));
  for (int i = 0; i < 1'000'000; ++i)
    film.add(0, 0, Rgb(1.0f));
  CHECK(film.at(0, 0).sum.g == 16'777'216.0 + 1'000'000.0);
}

TEST_CASE("film: samples that are negative or infinite or NaN are counted and not repaired") {
  for (const float bad : {-1.0f, not_a_number, infinity, -infinity})
    for (int channel = 0; channel < 3; ++channel) {
      Film film(1, 1);
      Rgb sample(1.0f);
      sample[channel] = bad;
      CAPTURE(sample);
      film.add(0, 0, Rgb(0.0f));
      CHECK(film.at(0, 0).bad == 0);
      film.add(0, 0, sample);
      CHECK(film.at(0, 0).count == 2);
      CHECK(film.at(0, 0).bad == 1);
      CHECK(!(film.at(0, 0).sum[channel] >= 0.0 && std::isfinite(film.at(0, 0).sum[channel])));
    }
}

TEST_CASE("film: the summary names the first pixel with a bad sample") {
  Film film(4, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x)
      film.add(x, y, Rgb(1.0f));
  CHECK(complaint(film).empty());
  film.add(3, 1, Rgb(-1.0f));
  film.add(3, 1, Rgb(not_a_number));
  film.add(0, 2, Rgb(infinity));

  const FilmSummary found = summary(film);
  CHECK(found.least == 1);
  CHECK(found.most == 3);
  CHECK(found.total == 4 * 3 + 3);
  CHECK(found.bad == 3);
  CHECK(found.first_bad == ivec2(3, 1));
  CHECK(complaint(film) ==
        "3 samples are negative, infinite or NaN; first in pixel (3, 1): 2 of its 3");
}
