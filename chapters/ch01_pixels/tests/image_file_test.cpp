// Pictures on disk. A PNG is read back by stb_image, which shares no code with the writer; a PFM is
// taken apart by hand.
#include "ch01_pixels/image_file.hpp"

#include <cstring>
#include <limits>
#include <sstream>
#include <string>

#include "ch01_pixels/tests/temporary_folder.hpp"
#include "common/testkit/catch.hpp"

namespace {

using lt::Image;
using lt::Rgb;

// 3 x 2 pixels, all different; the upper row is red, green, blue.
Image small_picture() {
  Image image(3, 2);
  image.at(0, 0) = {1.0f, 0.0f, 0.0f};
  image.at(1, 0) = {0.0f, 1.0f, 0.0f};
  image.at(2, 0) = {0.0f, 0.0f, 1.0f};
  image.at(0, 1) = {0.001f, 0.5f, 1.0f};
  image.at(1, 1) = {0.5f, 0.5f, 0.5f};
  image.at(2, 1) = {-1.0f, 4.0f, 0.001f};
  return image;
}

// Every pixel another colour, for sizes up to 16 x 16.
Image numbered_picture(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) = Rgb(lt::from_code(static_cast<std::uint8_t>(16 * y + x)), 0.5f, 1.0f);
  return image;
}

// The n-th number of a little-endian run of floats.
float float_at(const std::string& bytes, std::size_t start, std::size_t n) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i)
    bits |= std::uint32_t{static_cast<unsigned char>(bytes.at(start + 4 * n + i))} << 8 * i;
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

}  // namespace

TEST_CASE("PNG: read back it is the picture - first row on top - first pixel on the left") {
  const TemporaryFolder folder;
  lt::save_image(folder / "small.png", small_picture());
  const lt::Pixels8 read = lt::read_pixels8(folder / "small.png");
  CHECK(read.width == 3);
  CHECK(read.height == 2);
  const std::vector<int> expected = {255, 0,   0,   0,   255, 0,   0, 0,   255,  //
                                     3,   188, 255, 188, 188, 188, 0, 255, 3};
  CHECK(std::vector<int>(read.rgb.begin(), read.rgb.end()) == expected);
}

TEST_CASE("PNG: odd and narrow sizes arrive pixel by pixel") {
  const TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {7, 1}, {5, 3}, {16, 16}}) {
    const Image image = numbered_picture(width, height);
    lt::save_image(folder / "numbered.png", image);
    const lt::Pixels8 read = lt::read_pixels8(folder / "numbered.png");
    REQUIRE(read.width == width);
    REQUIRE(read.height == height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        REQUIRE(read.rgb.at(static_cast<std::size_t>(3 * (y * width + x))) == 16 * y + x);
  }
}

TEST_CASE("codes of a picture: read back as light and coded again they are the same") {
  lt::Pixels8 codes{16, 16, {}};
  for (int i = 0; i < 256; ++i)
    for (int c = 0; c < 3; ++c)
      codes.rgb.push_back(static_cast<std::uint8_t>((i + 85 * c) % 256));
  const Image image = lt::from_codes(codes);
  CHECK(image.at(15, 0).r == lt::from_code(15));
  CHECK(image.at(0, 1).r == lt::from_code(16));
  CHECK(image.at(0, 1).g == lt::from_code(101));
  CHECK(lt::to_codes(image).rgb == codes.rgb);
}

TEST_CASE("PFM: a short header and then the numbers - the lowest row first") {
  const TemporaryFolder folder;
  lt::save_image(folder / "small.pfm", small_picture());
  const std::string bytes = lt::read_file(folder / "small.pfm");
  std::istringstream header(bytes);
  std::string magic;
  int width = 0, height = 0;
  float scale = 0;
  header >> magic >> width >> height >> scale;
  CHECK(magic == "PF");
  CHECK(width == 3);
  CHECK(height == 2);
  CHECK(scale == -1.0f);  // below zero: little-endian
  const std::size_t start = static_cast<std::size_t>(header.tellg()) + 1;
  REQUIRE(bytes.size() == start + 3 * 2 * 3 * 4);
  const float expected[] = {0.001f, 0.5f, 1.0f, 0.5f, 0.5f, 0.5f, -1.0f, 4.0f, 0.001f,  // row 1
                            1.0f,   0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f,  0.0f, 1.0f};   // row 0
  for (std::size_t i = 0; i < 18; ++i)
    CHECK(float_at(bytes, start, i) == expected[i]);
}

TEST_CASE("PFM: numbers that no screen can show arrive as they are") {
  const TemporaryFolder folder;
  Image image(2, 1);
  image.at(0, 0) = {1e-30f, -2.5f, 60000.0f};
  image.at(1, 0) = {std::numeric_limits<float>::quiet_NaN(), lt::infinity, 0.1f};
  lt::save_image(folder / "odd.pfm", image);
  const lt::PixelsFloat read = lt::read_pfm(folder / "odd.pfm");
  REQUIRE(read.rgb.size() == 6);
  CHECK(read.rgb[0] == 1e-30f);
  CHECK(read.rgb[1] == -2.5f);
  CHECK(read.rgb[2] == 60000.0f);
  CHECK(std::isnan(read.rgb[3]));
  CHECK(read.rgb[4] == lt::infinity);
  CHECK(read.rgb[5] == 0.1f);
}

TEST_CASE("save_image: a name that is no picture is the person's mistake and leaves no file") {
  const TemporaryFolder folder;
  for (const std::string name : {"picture.jpg", "picture", "picture.", "picture.png.txt", ".png"}) {
    INFO(name);
    CHECK_THROWS_AS(lt::save_image(folder / name, Image(1, 1)), lt::InputError);
    CHECK_FALSE(std::filesystem::exists(folder / name));
  }
}

TEST_CASE("save_image: a place that cannot be written is the machine's fault") {
  const TemporaryFolder folder;
  lt::write_file_whole(folder / "file", "not a folder");
  for (const std::string name : {"file/picture.png", "file/picture.pfm"}) {
    CHECK_THROWS_AS(lt::save_image(folder / name, Image(1, 1)), lt::OutputError);
  }
  CHECK(lt::read_file(folder / "file") == "not a folder");
}
