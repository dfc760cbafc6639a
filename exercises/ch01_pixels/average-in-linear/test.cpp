#include "api.hpp"

#include <string>

#include "common/testkit/exercise.hpp"

namespace {

using exercise::Picture;

// The only code of a picture of 2 x 2 pixels.
int code_of_block(double a, double b, double c, double d) {
  const std::vector<int> codes = exercise::halved_codes({2, 2, {a, b, c, d}});
  REQUIRE(codes.size() == 1);
  return codes[0];
}

std::string gave(const std::string& block, int code, int expected) {
  return block + " became code " + std::to_string(code) + " and should become " +
         std::to_string(expected) + ".";
}

Picture random_picture(lt::TestRandom& random, int width, int height) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    const double brightest = random.uniform() < 0.2 ? 5.0 : 0.5;  // here and there a lamp
    picture.light.push_back(random.uniform(0.0, brightest));
  }
  return picture;
}

double mean_of_block(const Picture& picture, int x, int y) {
  const auto light = [&](int dx, int dy) {
    return picture.light[static_cast<std::size_t>((2 * y + dy) * picture.width + 2 * x + dx)];
  };
  return (light(0, 0) + light(1, 0) + light(0, 1) + light(1, 1)) / 4.0;
}

}  // namespace

TEST_CASE("two black and two white pixels become half the light") {
  const int code = code_of_block(0.0, 1.0, 1.0, 0.0);
  // The mean of codes 0, 255, 255, 0 is 127.5.
  lt::diagnose(code != 127 && code != 128, "average-encoded",
               gave("A checker of black and white", code, 188));
  CHECK(code_of_block(0.0, 1.0, 1.0, 0.0) == 188);
}

TEST_CASE("all four pixels of a block count") {
  // The mean is 0.375: 255 * (1.055 * 0.375^(1/2.4) - 0.055) = 164.7.
  const int code = code_of_block(0.1, 0.2, 0.4, 0.8);
  bool is_one_of_them = false;
  for (const double light : {0.1, 0.2, 0.4, 0.8})
    is_one_of_them = is_one_of_them || code == exercise::to_code(light);
  lt::diagnose(!is_one_of_them, "one-of-four", gave("The block 0.1, 0.2, 0.4, 0.8", code, 165));
  CHECK(code_of_block(0.1, 0.2, 0.4, 0.8) == 165);
}

TEST_CASE("a lamp keeps its light until the end") {
  // Mean light 2, brighter than white. Clamped first, the lamps would count as 1 and the mean as
  // 0.5: code 188.
  const int code = code_of_block(4.0, 0.0, 4.0, 0.0);
  lt::diagnose(code != 188, "clamp-first", gave("The block 4, 0, 4, 0", code, 255));
  CHECK(code_of_block(4.0, 0.0, 4.0, 0.0) == 255);
  CHECK(code_of_block(2.0, 0.0, 0.0, 0.0) == 188);  // half the light of white, all from one lamp
}

TEST_CASE("each block is made of its own four pixels") {
  const std::vector<int> codes = exercise::halved_codes({4,
                                                         2,
                                                         {0.0, 0.0, 1.0, 1.0,  //
                                                          0.0, 0.0, 0.6, 0.6}});
  REQUIRE(codes.size() == 2);
  // With a new row after 2 numbers instead of 4, the left block is 0, 0, 1, 1: half the light.
  lt::diagnose(codes[0] != 188, "wrong-stride",
               gave("The left block, which is black,", codes[0], 0));
  CHECK(codes[0] == 0);
  CHECK(codes[1] == 231);  // light 0.8: 255 * (1.055 * 0.8^(1/2.4) - 0.055) = 231.1
}

TEST_CASE("random pictures of any shape become smaller without losing light") {
  for (const auto seed : lt::seeds()) {
    lt::TestRandom random(seed);
    for (const auto& [width, height] : {std::pair(2, 2), {2, 6}, {8, 2}, {6, 4}}) {
      const Picture picture = random_picture(random, width, height);
      const std::vector<int> codes = exercise::halved_codes(picture);
      REQUIRE(codes.size() == static_cast<std::size_t>(width / 2 * (height / 2)));
      for (int y = 0; y < height / 2; ++y)
        for (int x = 0; x < width / 2; ++x) {
          const double light = mean_of_block(picture, x, y);
          const int code = codes[static_cast<std::size_t>(y * (width / 2) + x)];
          INFO("new pixel (" << x << ", " << y << ") of a picture of " << width << " x " << height
                             << ": mean light " << light);
          // The order of the sum may move light that lies between two codes to either.
          REQUIRE(code >= exercise::to_code(light - 1e-5));
          REQUIRE(code <= exercise::to_code(light + 1e-5));
        }
    }
  }
  lt::measured("a white dot among three black pixels keeps code " +
               std::to_string(code_of_block(1.0, 0.0, 0.0, 0.0)) +
               "; averaged as a code it would fade to 64");
}
