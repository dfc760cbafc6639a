#include "common/pixel_io.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "common/testkit/catch.hpp"
#include "common/testkit/exercise.hpp"
#include "common/tests/picture_bytes.hpp"
#include "common/tests/temporary_folder.hpp"

using namespace lt::test;

namespace {

lt::Pixels8 random_pixels(int width, int height) {
  lt::TestRandom random(static_cast<std::uint64_t>(width) << 32 | static_cast<unsigned>(height));
  lt::Pixels8 pixels{width, height, {}};
  for (int i = 0; i < width * height * 3; ++i)
    pixels.rgb.push_back(static_cast<std::uint8_t>(random.next_bits() & 0xff));
  return pixels;
}

using Codes = std::vector<std::uint8_t>;

}  // namespace

TEST_CASE("png: what is written is read back, odd widths and single rows too") {
  const TemporaryFolder folder;
  for (const int width : {1, 2, 3, 7, 64, 257})
    for (const int height : {1, 3, 50}) {
      const lt::Pixels8 written = random_pixels(width, height);
      lt::write_png(folder / "picture.png", written);
      const lt::Pixels8 read = lt::read_pixels8(folder / "picture.png");
      CHECK(read.width == width);
      CHECK(read.height == height);
      CHECK(read.rgb == written.rgb);
    }
  CHECK(folder.names() == std::vector<std::string>{"picture.png"});
}

TEST_CASE("png: the first three codes are the red, green and blue of the top left pixel") {
  // From a file that this test puts together: writer and reader could be wrong in the same way.
  const TemporaryFolder folder;
  const std::string rows =
      std::string("\0\x01\x02\x03\x04\x05\x06", 7) + std::string("\0\x07\x08\x09\x0a\x0b\x0c", 7);
  const auto path = put(folder / "a.png", png_of(2, 2, 8, PngColor::rgb, rows));
  CHECK(lt::read_pixels8(path).rgb == Codes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
}

TEST_CASE("png: grey becomes three equal codes, transparency is dropped, 16 bits become 8") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& png) {
    return lt::read_pixels8(put(folder / "a.png", png)).rgb;
  };
  CHECK(read(png_of(3, 1, 8, PngColor::grey, std::string("\0\x00\x80\xff", 4))) ==
        Codes{0, 0, 0, 128, 128, 128, 255, 255, 255});
  CHECK(read(png_of(1, 1, 8, PngColor::grey_alpha, std::string("\0\x30\x01", 3))) ==
        Codes{48, 48, 48});
  CHECK(read(png_of(1, 1, 8, PngColor::rgba, std::string("\0\x10\x20\x30\x00", 5))) ==
        Codes{16, 32, 48});
  CHECK(read(png_of(1, 1, 16, PngColor::rgb, std::string("\0\x10\x99\x20\x99\x30\x99", 7))) ==
        Codes{16, 32, 48});
}

TEST_CASE("jpeg: baseline, progressive and odd sizes are read") {
  const TemporaryFolder folder;
  const auto progressive = lt::read_pixels8(put(folder / "p.jpg", progressive_jpeg()));
  REQUIRE(progressive.rgb.size() == 8 * 8 * 3);
  for (std::size_t i = 0; i < progressive.rgb.size(); ++i)
    CHECK(std::abs(progressive.rgb[i] - std::array{200, 100, 50}[i % 3]) <= 3);
  for (const int width : {1, 3, 7, 17}) {
    const auto baseline = lt::read_pixels8(put(folder / "b.jpg", baseline_jpeg(width, 5)));
    CHECK(baseline.width == width);
    CHECK(baseline.height == 5);
    CHECK(baseline.rgb.size() == static_cast<std::size_t>(width) * 5 * 3);
  }
}

TEST_CASE("jpeg: bytes after the end of the picture do no harm") {
  const TemporaryFolder folder;
  const auto path = put(folder / "a.jpg", baseline_jpeg(16, 16) + std::string(100, '\0'));
  CHECK(lt::read_pixels8(path).width == 16);
}

TEST_CASE("pfm: every float survives, bit for bit") {
  const TemporaryFolder folder;
  using Limits = std::numeric_limits<float>;
  const std::vector<float> awkward = {
      0.0f, -0.0f, 1e-45f, Limits::max(), -Limits::max(), Limits::infinity(), Limits::quiet_NaN(),
      0.1f, -3.5f};
  for (const int width : {1, 3, 7})
    for (const int height : {1, 2, 5}) {
      lt::PixelsFloat written{width, height, {}};
      for (int i = 0; i < width * height * 3; ++i)
        written.rgb.push_back(awkward[static_cast<std::size_t>(i) % awkward.size()]);
      lt::write_pfm(folder / "a.pfm", written);
      const lt::PixelsFloat read = lt::read_pfm(folder / "a.pfm");
      REQUIRE(read.width == width);
      REQUIRE(read.height == height);
      REQUIRE(read.rgb.size() == written.rgb.size());
      for (std::size_t i = 0; i < read.rgb.size(); ++i)
        CHECK(std::bit_cast<std::uint32_t>(read.rgb[i]) ==
              std::bit_cast<std::uint32_t>(written.rgb[i]));
    }
}

TEST_CASE("pfm: the file starts with the bottom row, little-endian") {
  const TemporaryFolder folder;
  // 1.0f is 0x3f800000, 2.0f is 0x40000000.
  lt::write_pfm(folder / "a.pfm", {1, 2, {1, 1, 1, 2, 2, 2}});
  const std::string one("\x00\x00\x80\x3f", 4);
  const std::string two("\x00\x00\x00\x40", 4);
  CHECK(get(folder / "a.pfm") == "PF\n1 2\n-1.0\n" + two + two + two + one + one + one);
}

TEST_CASE("pfm: both byte orders, grey, and a scale are understood") {
  const TemporaryFolder folder;
  const std::string one_big("\x3f\x80\x00\x00", 4);
  const std::string two_big("\x40\x00\x00\x00", 4);
  const std::string one_little("\x00\x00\x80\x3f", 4);
  const auto read = [&](const std::string& pfm) {
    return lt::read_pfm(put(folder / "a.pfm", pfm)).rgb;
  };
  using Floats = std::vector<float>;
  CHECK(read("PF\n1 1\n1.0\n" + one_big + two_big + one_big) == Floats{1, 2, 1});
  CHECK(read("Pf\n2 1\n1\n" + one_big + two_big) == Floats{1, 1, 1, 2, 2, 2});
  CHECK(read("Pf\n1 2\n1\n" + one_big + two_big) == Floats{2, 2, 2, 1, 1, 1});
  CHECK(read("Pf 1 1 -2.5\n" + one_little) == Floats{2.5f, 2.5f, 2.5f});
  // A pixel may start with a byte that looks like white space.
  CHECK(read(std::string("Pf\n1 1\n-1\n\n\0\x80\x3f", 14))[0] == 1.0f + 10 * 0x1p-23f);
}
