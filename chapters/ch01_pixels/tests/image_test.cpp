// Pictures in memory, and from functions.
#include "ch01_pixels/image.hpp"

#include <vector>

#include "ch01_pixels/paint.hpp"
#include "common/testkit/catch.hpp"

using lt::Image;
using lt::Rgb;

TEST_CASE("Image: every pixel has its own place") {
  Image image(5, 3, Rgb(-1.0f));
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x)
      image.at(x, y) = Rgb(static_cast<float>(10 * y + x));
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x)
      CHECK(image.at(x, y) == Rgb(static_cast<float>(10 * y + x)));
}

TEST_CASE("Image: a new one is black or as asked for") {
  CHECK(Image(2, 2).at(1, 1) == Rgb(0.0f));
  CHECK(Image(2, 2, Rgb(0.1f, 0.2f, 0.3f)).at(1, 0) == Rgb(0.1f, 0.2f, 0.3f));
}

TEST_CASE("paint: a pixel holds the function's value at its middle") {
  const Image image = lt::paint(4, 2, [](lt::vec2 p) { return Rgb(p.x, p.y, p.x * p.y); });
  CHECK(image.width() == 4);
  CHECK(image.height() == 2);
  CHECK(image.at(0, 0) == Rgb(0.5f, 0.5f, 0.25f));
  CHECK(image.at(3, 0) == Rgb(3.5f, 0.5f, 1.75f));
  CHECK(image.at(0, 1) == Rgb(0.5f, 1.5f, 0.75f));
}

TEST_CASE("paint: the function is asked once for each pixel - row by row from the top left") {
  std::vector<lt::vec2> asked;
  const Image image = lt::paint(2, 2, [&](lt::vec2 p) {
    asked.push_back(p);
    return Rgb(0.0f);
  });
  CHECK(image.width() == 2);
  CHECK(asked == std::vector<lt::vec2>{{0.5f, 0.5f}, {1.5f, 0.5f}, {0.5f, 1.5f}, {1.5f, 1.5f}});
}

TEST_CASE("changed: the change reaches each number and nothing else") {
  const Image image = lt::paint(3, 2, [](lt::vec2 p) { return Rgb(p.x, p.y, 1.0f); });
  const Image twice = lt::changed(image, [](float value) { return 2.0f * value; });
  REQUIRE(twice.width() == 3);
  REQUIRE(twice.height() == 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x)
      CHECK(twice.at(x, y) == 2.0f * image.at(x, y));
}
