// Every reader against files that are wrong by accident or on purpose: one line, never a crash
// (the suite also runs under ASan and UBSan).
#include <functional>

#include "common/pixel_io.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/exercise.hpp"
#include "common/tests/picture_bytes.hpp"
#include "common/tests/temporary_folder.hpp"

using namespace lt::test;
namespace fs = std::filesystem;

namespace {

// A reader, reduced to "how many values did it give and how many should it have given".
struct Reader {
  std::string extension;
  std::function<bool(const fs::path&)> gives_a_whole_picture;
};

template <class Pixels>
bool is_whole(const Pixels& pixels) {
  return pixels.width >= 1 && pixels.height >= 1 &&
         pixels.rgb.size() == static_cast<std::size_t>(pixels.width) * pixels.height * 3;
}

const Reader codes{"png", [](const fs::path& path) { return is_whole(lt::read_pixels8(path)); }};
const Reader floats{"pfm", [](const fs::path& path) { return is_whole(lt::read_pfm(path)); }};

std::string complaint(const Reader& reader, const fs::path& path) {
  return input_error([&] { (void)reader.gives_a_whole_picture(path); });
}

std::string good_png() {
  std::string rows;
  for (int y = 0; y < 9; ++y) {
    rows.push_back('\0');
    for (int x = 0; x < 7 * 3; ++x)
      rows.push_back(static_cast<char>(x * 11 + y * 5));
  }
  return png_of(7, 9, 8, PngColor::rgb, rows);
}

// As our own writer compresses it, with filters and Huffman codes.
std::string compressed_png(const TemporaryFolder& folder) {
  lt::Pixels8 pixels{31, 17, {}};
  for (int i = 0; i < 31 * 17 * 3; ++i)
    pixels.rgb.push_back(static_cast<std::uint8_t>(i * i / 50));
  lt::write_png(folder / "written.png", pixels);
  return get(folder / "written.png");
}

std::string good_pfm() {
  return "PF\n4 3\n-1.0\n" + std::string(4 * 3 * 3 * 4, '\x3e');
}

struct Sample {
  Reader reader;
  std::string bytes;
};

std::vector<Sample> samples(const TemporaryFolder& folder) {
  return {{codes, good_png()},
          {codes, compressed_png(folder)},
          {codes, baseline_jpeg(20, 11)},
          {codes, progressive_jpeg()},
          {floats, good_pfm()}};
}

}  // namespace

TEST_CASE("hostile pictures: missing, a folder, empty, or something else") {
  const TemporaryFolder folder;
  for (const Reader& reader : {codes, floats}) {
    CHECK(is_one_line_with_remedy(complaint(reader, folder / "missing"), "missing"));
    CHECK(is_one_line_with_remedy(complaint(reader, folder.path()), folder.path().string()));
    for (const std::string bytes :
         {"", "P", "PF", "PF\n", "GIF89a 1234567890", "\x89PNG", "\x89PNG\r\n\x1a\n",
          "\xff\xd8\xff", "\xff\xd8\xff\xda\xff\xd9", "BM123456789012345678901234567890"}) {
      const std::string line = complaint(reader, put(folder / "wrong", bytes));
      INFO(line);
      CHECK(is_one_line_with_remedy(line, "wrong"));
    }
  }
}

TEST_CASE("hostile pictures: a file cut off anywhere is refused") {
  const TemporaryFolder folder;
  for (const Sample& sample : samples(folder)) {
    REQUIRE(sample.reader.gives_a_whole_picture(put(folder / "whole", sample.bytes)));
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      const std::string line =
          complaint(sample.reader, put(folder / "cut", sample.bytes.substr(0, size)));
      if (!is_one_line_with_remedy(line, "cut"))
        FAIL("cut to " << size << " of " << sample.bytes.size() << " bytes: " << line);
    }
  }
}

TEST_CASE("hostile pictures: bytes changed at random give a picture or one line") {
  const TemporaryFolder folder;
  lt::TestRandom random(7);
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(random.next_bits() % n);
  };
  for (const Sample& sample : samples(folder))
    for (int round = 0; round < 150; ++round) {
      std::string bytes = sample.bytes;
      for (std::size_t changes = 1 + below(4); changes > 0; --changes)
        bytes[below(bytes.size())] = static_cast<char>(below(256));
      const fs::path path = put(folder / "changed", bytes);
      bool is_whole_picture = false;
      const std::string line =
          input_error([&] { is_whole_picture = sample.reader.gives_a_whole_picture(path); });
      if (!is_whole_picture && !is_one_line_with_remedy(line, "changed"))
        FAIL("round " << round << " of a file of " << bytes.size() << " bytes: " << line);
    }
}

TEST_CASE("hostile pictures: a header that claims a huge or no picture is refused at once") {
  const TemporaryFolder folder;
  const auto claims = [&](const Reader& reader, const std::string& bytes, const std::string& size) {
    const std::string line = complaint(reader, put(folder / "claim", bytes));
    INFO(line);
    CHECK(is_one_line_with_remedy(line, "claim"));
    CHECK(contains(line, "claims to be " + size + " pixels"));
  };
  const auto png = [](std::uint32_t width, std::uint32_t height) {
    return png_of(width, height, 8, PngColor::rgb, "");
  };
  claims(codes, png(1'000'000'000, 1'000'000'000), "1000000000 x 1000000000");
  claims(codes, png(16385, 1), "16385 x 1");
  claims(codes, png(1, 0xffffffff), "1 x 4294967295");
  claims(codes, png(0, 5), "0 x 5");
  claims(codes, png(5, 0), "5 x 0");
  // The largest JPEG. Height and width stand 5 bytes after the marker ff c0.
  std::string jpeg = baseline_jpeg(16, 16);
  jpeg.replace(jpeg.find("\xff\xc0") + 5, 4, "\xff\xff\xff\xff");
  claims(codes, jpeg, "65535 x 65535");
  claims(floats, "PF\n1000000000 1000000000\n-1\nxxxx", "1000000000 x 1000000000");
  claims(floats, "PF\n-4 3\n-1\n", "-4 x 3");
  claims(floats, "PF\n0 3\n-1\n", "0 x 3");
  claims(floats, "PF\n3 16385\n-1\n", "3 x 16385");
}

TEST_CASE("hostile pictures: a JPEG without width is refused") {
  const TemporaryFolder folder;
  std::string jpeg = baseline_jpeg(16, 16);
  jpeg.replace(jpeg.find("\xff\xc0") + 5, 4, std::string(4, '\0'));
  CHECK(is_one_line_with_remedy(complaint(codes, put(folder / "a.jpg", jpeg)), "a.jpg"));
}

TEST_CASE("hostile pictures: a JPEG whose Huffman table has more than 256 symbols is refused") {
  // stb_image 2.27 writes such a table beyond its arrays. The first table's 16 counts follow
  // ff c4, two bytes of length, and the table's number.
  const TemporaryFolder folder;
  for (const std::string& good : {baseline_jpeg(16, 16), progressive_jpeg()}) {
    std::string jpeg = good;
    jpeg.replace(jpeg.find("\xff\xc4") + 5, 16, std::string(16, '\xff'));
    CHECK(is_one_line_with_remedy(complaint(codes, put(folder / "a.jpg", jpeg)), "a.jpg"));
  }
}

TEST_CASE("hostile pictures: a JPEG without its Huffman tables does no harm") {
  // stb_image 2.27 decodes it with tables that were never written.
  const TemporaryFolder folder;
  for (const std::string& good : {baseline_jpeg(16, 16), progressive_jpeg()}) {
    std::string jpeg = good;
    for (std::size_t at = jpeg.find("\xff\xc4"); at != jpeg.npos; at = jpeg.find("\xff\xc4"))
      jpeg[at + 1] = '\xef';  // a segment that readers skip
    bool is_whole_picture = false;
    const auto path = put(folder / "a.jpg", jpeg);
    const auto line = input_error([&] { is_whole_picture = codes.gives_a_whole_picture(path); });
    CHECK((is_whole_picture || is_one_line_with_remedy(line, "a.jpg")));
  }
}

TEST_CASE("hostile pictures: a PFM header that is no header is refused") {
  const TemporaryFolder folder;
  const std::string pixel(12, '\x3e');
  for (const std::string header :
       {"PF\n1.5 1\n-1\n", "PF\n1 x\n-1\n", "PF\n1\n-1\n", "PF\n1 1\n0\n", "PF\n1 1\nnan\n",
        "PF\n1 1\n1e999\n", "PF\n1 1\n-1x\n", "PF\n1 1\n\n", "PF\n99999999999999999999 1\n-1\n",
        "PFF\n1 1\n-1\n", "pf\n1 1\n-1\n", "P6\n1 1\n-1\n", "PF\n+1 1\n-1\n"}) {
    const std::string line = complaint(floats, put(folder / "a.pfm", header + pixel));
    INFO(header << ": " << line);
    CHECK(is_one_line_with_remedy(line, "a.pfm"));
  }
  CHECK(floats.gives_a_whole_picture(put(folder / "a.pfm", "PF\n1 1\n-1\n" + pixel)));
  const auto extra = put(folder / "a.pfm", "PF\n1 1\n-1\n" + pixel + "x");
  CHECK(contains(complaint(floats, extra), "has 13 bytes of pixels, not the 12"));
}
