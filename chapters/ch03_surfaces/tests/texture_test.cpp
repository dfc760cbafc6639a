// Looking textures up: at texels, between them, beyond the edges.
#include "ch03_surfaces/texture.hpp"

#include <algorithm>

#include "ch03_surfaces/tests/random_input.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// Every texel different, in all three channels.
Image numbered(int width, int height) {
  Image texture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      texture.at(x, y) = Rgb(x, y, x + 10 * y);
  return texture;
}

vec2 texel_center(const Image& texture, int x, int y) {
  return (vec2(x, y) + 0.5f) / vec2(texture.width(), texture.height());
}

float error(Rgb a, Rgb b) {
  return distance(a, b);
}

}  // namespace

TEST_CASE("wrap: every whole number finds its texel") {
  CHECK(wrap(0, 4) == 0);
  CHECK(wrap(3, 4) == 3);
  CHECK(wrap(4, 4) == 0);
  CHECK(wrap(-1, 4) == 3);
  CHECK(wrap(-4, 4) == 0);
  CHECK(wrap(-5, 4) == 3);
  CHECK(wrap(-7, 1) == 0);
}

TEST_CASE("wrap: for neighbours the short way round is the long way's texel") {
  for (const int n : {1, 2, 7})
    for (int i = -n; i < 2 * n; ++i)
      CHECK(wrap_near(i, n) == wrap(i, n));
}

TEST_CASE("bilinear: the middle of a texel is exactly that texel") {
  const Image texture = numbered(8, 4);  // powers of two: (i + 0.5) / width is exact
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x)
      CHECK(bilinear(texture, texel_center(texture, x, y)) == texture.at(x, y));
}

TEST_CASE("bilinear: textures of odd width are no exception") {
  const Image texture = numbered(7, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x)
      CHECK(error(bilinear(texture, texel_center(texture, x, y)), texture.at(x, y)) < 1e-4f);
}

TEST_CASE("bilinear: a ramp stays a ramp between the texels") {
  const Image texture = numbered(16, 16);  // the color is linear in x and y
  RandomInput random(1);
  for (int i = 0; i < 1000; ++i) {
    const vec2 texel = random.point(0.0f, 15.0f);  // between the first and the last middle
    const Rgb expected(texel.x, texel.y, texel.x + 10.0f * texel.y);
    CHECK(error(bilinear(texture, (texel + 0.5f) / 16.0f), expected) < 1e-4f);
  }
}

TEST_CASE("bilinear: the edge is the mean of the two sides") {
  Image texture(2, 1);
  texture.at(1, 0) = Rgb(1.0f);
  CHECK(bilinear(texture, {0.0f, 0.5f}).x == 0.5f);
  CHECK(bilinear(texture, {1.0f, 0.5f}).x == 0.5f);
  CHECK(bilinear(texture, {0.5f, 0.5f}).x == 0.5f);
}

TEST_CASE("bilinear: outside 0 to 1 the texture repeats, to the left and upwards too") {
  const Image texture = numbered(8, 4);
  for (const float whole : {-3.0f, -1.0f, 1.0f, 2.0f}) {
    CHECK(bilinear(texture, {0.75f + whole, 0.3f}) == bilinear(texture, {0.75f, 0.3f}));
    CHECK(error(bilinear(texture, {0.3f, 0.75f + whole}), bilinear(texture, {0.3f, 0.75f})) <
          1e-5f);
  }
  // u = -0.25 is 0.75, in the middle between texels 5 and 6.
  CHECK(bilinear(texture, {-0.25f, 0.125f}).x == 5.5f);
}

TEST_CASE("bilinear: just below 0, where rounding makes 1, there is a texel too") {
  const Image texture = numbered(8, 4);
  CHECK(bilinear(texture, {-1e-9f, -1e-9f}) == bilinear(texture, {0.0f, 0.0f}));
  CHECK(nearest(texture, {-1e-9f, 0.5f}) == nearest(texture, {0.0f, 0.5f}));
}

TEST_CASE("bilinear: one texel is one color everywhere") {
  const Image texture(1, 1, Rgb(0.25f, 0.5f, 0.75f));
  RandomInput random(2);
  for (int i = 0; i < 1000; ++i)
    CHECK(error(bilinear(texture, random.point(-5.0f, 5.0f)), texture.at(0, 0)) < 1e-6f);
}

TEST_CASE("bilinear: never brighter nor darker than the texels") {
  Image texture(5, 3);
  RandomInput random(3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x)
      texture.at(x, y) = Rgb(random.uniform(0.2f, 0.7f));
  float least = 1.0f, most = 0.0f;
  for (int i = 0; i < 10'000; ++i) {
    const float value = bilinear(texture, random.point(-2.0f, 2.0f)).x;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  CHECK(least >= 0.2f - 1e-6f);
  CHECK(most <= 0.7f + 1e-6f);
}

TEST_CASE("nearest: a texel's square ends half way to the next middle") {
  const Image texture = numbered(4, 4);
  CHECK(nearest(texture, {0.249f, 0.1f}).x == 0.0f);
  CHECK(nearest(texture, {0.251f, 0.1f}).x == 1.0f);
  CHECK(nearest(texture, {-0.01f, 0.1f}).x == 3.0f);
  CHECK(nearest(texture, {0.1f, 1.01f}).y == 0.0f);
}
