// Averages are averages of light.
#include "ch01_pixels/halve.hpp"

#include "ch01_pixels/mistakes.hpp"
#include "common/testkit/catch.hpp"

namespace {

using lt::Image;
using lt::Rgb;

// A picture of one row.
Image row_of(std::initializer_list<float> values) {
  Image image(static_cast<int>(values.size()), 1);
  int x = 0;
  for (const float value : values)
    image.at(x++, 0) = Rgb(value);
  return image;
}

Image checker(int side, float bright) {
  return lt::paint(side, side, [bright](lt::vec2 p) {
    return Rgb((static_cast<int>(p.x) + static_cast<int>(p.y)) % 2 == 0 ? 0.0f : bright);
  });
}

// Uneven light, brighter than white here and there, another in each channel.
Image uneven(int width, int height) {
  return lt::paint(width, height, [](lt::vec2 p) {
    return Rgb(glm::fract(0.37f * p.x + 0.61f * p.y), 3.0f * glm::fract(p.x * p.y), 0.1f * p.y);
  });
}

glm::dvec3 mean(const Image& image) {
  glm::dvec3 sum(0.0);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      sum += glm::dvec3(image.at(x, y));
  return sum / (static_cast<double>(image.width()) * image.height());
}

}  // namespace

TEST_CASE("halve: black and white squares become half the light - code 188") {
  const Image half = lt::halve(checker(4, 1.0f));
  REQUIRE(half.width() == 2);
  REQUIRE(half.height() == 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) {
      CHECK(half.at(x, y) == Rgb(0.5f));
      CHECK(int{lt::to_code(half.at(x, y).g)} == 188);
    }
}

TEST_CASE("halve: light beyond white counts in full") {
  const Image once = lt::halve(row_of({4.0f, 0.0f, 0.0f, 0.0f}));
  CHECK(once.at(0, 0) == Rgb(2.0f));  // still brighter than a screen can be
  CHECK(lt::halve(once).at(0, 0) == Rgb(1.0f));
}

TEST_CASE("halve: each pixel is made of the four that it covers") {
  const Image image = lt::paint(4, 4, [](lt::vec2 p) { return Rgb(p.x, 10.0f * p.y, p.x * p.y); });
  const Image half = lt::halve(image);
  // The means of x, 10 y and x y over the middles 2.5, 3.5 (x) and 0.5, 1.5 (y).
  CHECK(half.at(1, 0) == Rgb(3.0f, 10.0f, 3.0f));
  CHECK(half.at(0, 1) == Rgb(1.0f, 30.0f, 3.0f));
  CHECK(half.at(1, 1) == Rgb(3.0f, 30.0f, 9.0f));
}

TEST_CASE("halve: the mean light of a picture stays") {
  const Image image = uneven(64, 48);
  const glm::dvec3 before = mean(image);
  const glm::dvec3 after = mean(lt::halve(lt::halve(image)));
  for (int c = 0; c < 3; ++c)
    CHECK(after[c] == Approx(before[c]).epsilon(1e-6));
}

TEST_CASE("halve: of an odd side the last row or column counts twice") {
  const Image half = lt::halve(row_of({1.0f, 3.0f, 7.0f}));
  REQUIRE(half.width() == 2);
  REQUIRE(half.height() == 1);
  CHECK(half.at(0, 0) == Rgb(2.0f));
  CHECK(half.at(1, 0) == Rgb(7.0f));

  const Image column = lt::halve(Image(1, 5, Rgb(0.25f)));
  REQUIRE(column.height() == 3);
  CHECK(column.at(0, 2) == Rgb(0.25f));
}

TEST_CASE("halve: a single pixel stays as it is") {
  const Image one = lt::halve(Image(1, 1, Rgb(0.1f, 0.2f, 0.3f)));
  REQUIRE(one.width() == 1);
  REQUIRE(one.height() == 1);
  CHECK(glm::distance(one.at(0, 0), Rgb(0.1f, 0.2f, 0.3f)) < 1e-7f);
}

TEST_CASE("halve_codes: black and white squares become 21 percent of white - not 50") {
  const Image half = lt::halve_codes(checker(2, 1.0f));
  CHECK(half.at(0, 0).r == Approx(0.2140411405).epsilon(1e-6));  // decode(127.5 / 255)
}

TEST_CASE("halve_codes: it is never brighter than the light") {
  // README (1.5): the curve bends downward. Even at the joint it misses that by less than 1e-7.
  const Image image = uneven(64, 64);
  const Image right = lt::halve(image);
  const Image wrong = lt::halve_codes(image);
  for (int y = 0; y < right.height(); ++y)
    for (int x = 0; x < right.width(); ++x)
      for (int c = 0; c < 3; ++c)
        REQUIRE(wrong.at(x, y)[c] <= right.at(x, y)[c] + 1e-6f);
}
