// The pictures of the text show what the text says of them.
#include "ch01_pixels/views.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "ch01_pixels/curve_plots.hpp"
#include "common/testkit/catch.hpp"

namespace {

using lt::Image;
using lt::Rgb;

Image view(const std::string& name, int width, int height, bool wrong = false) {
  return lt::make_view({name, width, height, 0.0f, wrong});
}

// Mean light of the pixels from (x0, y0) up to, not including, (x1, y1).
glm::dvec3 mean(const Image& image, int x0, int y0, int x1, int y1) {
  glm::dvec3 sum(0.0);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      sum += glm::dvec3(image.at(x, y));
  return sum / (static_cast<double>(x1 - x0) * (y1 - y0));
}

glm::dvec3 mean(const Image& image) {
  return mean(image, 0, 0, image.width(), image.height());
}

std::set<int> red_codes(const Image& image) {
  std::set<int> codes;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      codes.insert(lt::to_code(image.at(x, y).r));
  return codes;
}

}  // namespace

TEST_CASE("views: every number of every picture is finite and not negative") {
  for (const std::string name : {"evening", "checker", "gradient", "glow", "ramp", "galaxy"}) {
    INFO(name);
    const Image image = view(name, 75, 60);
    REQUIRE(image.width() == 75);
    REQUIRE(image.height() == 60);
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 75; ++x)
        for (int c = 0; c < 3; ++c) {
          REQUIRE(std::isfinite(image.at(x, y)[c]));
          REQUIRE(image.at(x, y)[c] >= 0.0f);
        }
  }
}

TEST_CASE("views: one stop more is twice the light - and the mistake comes after it") {
  const Rgb plain = lt::make_view({"evening", 25, 20, 0.0f, false}).at(3, 3);
  const Rgb brighter = lt::make_view({"evening", 25, 20, 1.0f, false}).at(3, 3);
  const Rgb wrong = lt::make_view({"evening", 25, 20, 1.0f, true}).at(3, 3);
  for (int c = 0; c < 3; ++c) {
    CHECK(brighter[c] == Approx(2.0f * plain[c]).epsilon(1e-6));
    CHECK(wrong[c] == Approx(lt::decode_srgb(2.0f * plain[c])).epsilon(1e-5));
  }
}

TEST_CASE("views: what cannot be made is the person's mistake") {
  for (const std::string name : {"checker", "gradient", "ramp"}) {
    CHECK_THROWS_AS(view(name, 8, 8, true), lt::InputError);
  }
  CHECK_THROWS_AS(view("evening", 4097, 8), lt::InputError);
  CHECK_THROWS_AS(view("galaxy", 8, 4097), lt::InputError);
}

TEST_CASE("checker: squares and left patch send half the light - the right patch a fifth") {
  const Image image = view("checker", 480, 240);
  CHECK(mean(image, 0, 0, 480, 40).g == Approx(0.5).epsilon(1e-6));  // above the patches
  CHECK(image.at(120, 120) == Rgb(0.5f));
  CHECK(int{lt::to_code(image.at(120, 120).g)} == 188);
  CHECK(int{lt::to_code(image.at(360, 120).g)} == 128);
  CHECK(image.at(360, 120).g == Approx(0.21586).epsilon(1e-4));
}

TEST_CASE("gradient: the squares send the light of the lower row - not that of the upper one") {
  const Image image = view("gradient", 480, 240);
  for (int x = 0; x + 48 <= 480; x += 48) {
    const glm::dvec3 codes = mean(image, x, 0, x + 48, 80);
    const glm::dvec3 squares = mean(image, x, 80, x + 48, 160);
    const glm::dvec3 light = mean(image, x, 160, x + 48, 240);
    INFO("columns from " << x);
    // 24 x 40 squares stand for a share: a few of them more or less are within 2 percent.
    for (int c = 0; c < 3; ++c)
      CHECK(squares[c] == Approx(light[c]).margin(0.02));
    CHECK(codes.r <= light.r + 1e-6);
    CHECK(codes.g <= light.g + 1e-6);
  }
  // In the middle, red is the mean of codes 237 and 48, not the mean of 0.85 and 0.03.
  CHECK(image.at(240, 120 + 80).r == Approx(0.44).epsilon(0.01));
  CHECK(image.at(240, 20).r == Approx(lt::decode_srgb((237 + 48) / 2.0f / 255.0f)).epsilon(0.03));
}

TEST_CASE("glow: equal steps of light leave 16 levels where sRGB has 70") {
  // 0.06 * 255 = 15.3, so codes 0 to 15: 16 levels. sRGB encodes 0.06 as 0.2718, times 255 is 69.3:
  // codes 0 to 69, which are 70 levels. Far from the middle the glow is not quite black, so that
  // the lowest codes need not occur.
  const std::set<int> equal = red_codes(view("glow", 480, 320, true));
  const std::set<int> srgb = red_codes(view("glow", 480, 320));
  CHECK(equal.size() <= 16);
  CHECK(*srgb.rbegin() == 69);
  CHECK(srgb.size() > 4 * equal.size() - 16);
}

TEST_CASE("ramp: each patch sends twice the light of the one before") {
  const Image image = view("ramp", 520, 240);
  for (int patch = 0; patch < 12; ++patch) {
    const int here = 40 * patch + 20;
    for (const int row : {40, 120, 200})
      CHECK(image.at(here + 40, row) == 2.0f * image.at(here, row));
    CHECK(image.at(here, 200) == image.at(here, 120) / 16.0f);
  }
  CHECK(image.at(8 * 40 + 20, 40) == Rgb(1.0f));  // eight stops above 1/256
}

TEST_CASE("evening: the sun is brighter than a screen and water mirrors what stands above it") {
  CHECK(lt::evening({0.17f, 0.06f}).r > 4.0f);
  // A hair below the waterline the ripples shift nothing that matters.
  const Rgb above = lt::evening({-0.3f, lt::waterline + 1e-5f});
  const Rgb below = lt::evening({-0.3f, lt::waterline - 1e-5f});
  const Rgb expected = Rgb(0.45f, 0.52f, 0.60f) * above + Rgb(0.001f, 0.004f, 0.010f);
  CHECK(glm::distance(below, expected) < 1e-5f);
}

TEST_CASE("evening: the picture stands upright - sky above and sun above its reflection") {
  const Image image = lt::evening_picture(90, 72);
  CHECK(image.at(0, 0).b > image.at(0, 0).r);  // the blue of the upper sky
  CHECK(image.at(45 + 12, 36 - 4).r > 4.0f);   // the sun, right of the middle and above it
  CHECK(image.at(45 + 12, 71).r < 4.0f);
}

TEST_CASE("galaxy: halving codes loses more than half of the light") {
  const Image right = view("galaxy", 120, 96);
  const Image wrong = view("galaxy", 120, 96, true);
  const Image stars = lt::galaxy(480, 384);
  for (int c = 0; c < 3; ++c) {
    CHECK(mean(right)[c] == Approx(mean(stars)[c]).epsilon(1e-5));
    CHECK(mean(wrong)[c] < 0.5 * mean(right)[c]);
  }
}

TEST_CASE("plots: sRGB codes are finer than equal steps of light below a quarter of white") {
  const lt::Plot plot = lt::step_plot();
  const lt::Series& srgb = plot.series.at(0);
  for (std::size_t i = 0; i < srgb.x.size(); ++i) {
    const double equal_step = 100.0 / 255.0 / srgb.x[i];  // percent of the light there
    if (srgb.x[i] < 0.24) CHECK(srgb.y[i] < equal_step);
    if (srgb.x[i] > 0.26) CHECK(srgb.y[i] > equal_step);
  }
  CHECK(srgb.y.front() == Approx(100.0).epsilon(1e-5));  // code 2 sends twice the light of code 1
  CHECK(srgb.y.back() < 1.0);
}
