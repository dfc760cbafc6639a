#include "common/pixel_io.hpp"

#define STBI_NO_STDIO
#define STBI_WRITE_NO_STDIO
#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstring>
#include <locale>
#include <memory>
#include <sstream>
#include <string_view>

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/jpeg_check.hpp"

namespace lt {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& problem) {
  throw InputError(printable(path.string()) + ": " + problem);
}

// Width and height as a file claims them: checked before anything is allocated.
void check_size(const fs::path& path, long long width, long long height) {
  if (width < 1 || height < 1 || width > max_image_side || height > max_image_side)
    fail(path, "claims to be " + std::to_string(width) + " x " + std::to_string(height) +
                   " pixels; give a picture of 1 to " + std::to_string(max_image_side) +
                   " pixels a side");
}

std::size_t value_count(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
}

bool is_png(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1a\n");
}

bool is_jpeg(std::string_view bytes) {
  return bytes.starts_with("\xff\xd8\xff");
}

// A big-endian 32-bit number of a PNG's header.
std::uint32_t big_endian_32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

// What can be said against a PNG or JPEG before it is decoded.
void check_header(const fs::path& path, std::string_view bytes) {
  if (!is_png(bytes) && !is_jpeg(bytes)) fail(path, "is neither PNG nor JPEG; convert it to PNG");
  if (is_png(bytes) && bytes.size() >= 24)
    check_size(path, big_endian_32(bytes, 16), big_endian_32(bytes, 20));
  const bool has_png_end = bytes.rfind("IEND\xae\x42\x60\x82") != bytes.npos;
  if (is_png(bytes) ? !has_png_end : !is_sound_jpeg(bytes))
    fail(path, "is damaged or incomplete; fetch or export it again");
}

}  // namespace

Pixels8 read_pixels8(const fs::path& path) {
  const std::string bytes = read_file(path);
  check_header(path, bytes);
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());  // read_file accepts at most 2^30
  Pixels8 pixels;
  int channels = 0;
  const bool has_header =
      stbi_info_from_memory(data, size, &pixels.width, &pixels.height, &channels);
  if (has_header) check_size(path, pixels.width, pixels.height);

  using Decoded = std::unique_ptr<stbi_uc, decltype(&stbi_image_free)>;
  const Decoded decoded(
      has_header ? stbi_load_from_memory(data, size, &pixels.width, &pixels.height, &channels, 3)
                 : nullptr,
      &stbi_image_free);
  if (!decoded)
    fail(path, "is damaged or incomplete (" + std::string(stbi_failure_reason()) +
                   "); fetch or export it again");
  pixels.rgb.assign(decoded.get(), decoded.get() + value_count(pixels.width, pixels.height));
  return pixels;
}

void write_png(const fs::path& path, const Pixels8& pixels) {
  assert(pixels.width >= 1 && pixels.height >= 1);
  assert(pixels.rgb.size() == value_count(pixels.width, pixels.height));
  std::string png;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  if (!stbi_write_png_to_func(append, &png, pixels.width, pixels.height, 3, pixels.rgb.data(),
                              pixels.width * 3))
    throw OutputError("cannot write " + printable(path.string()) + ": not enough memory");
  write_file_whole(path, png);
}

namespace {

struct PfmHeader {
  int channels = 0;
  int width = 0;
  int height = 0;
  double scale = 0;           // < 0: little-endian; |scale|: factor to apply
  std::string_view floats{};  // what follows the header
};

// The next word of a PFM's header; `rest` then starts after the one white space that ends it.
std::string_view take_word(std::string_view& rest) {
  constexpr std::string_view space = " \t\r\n";
  rest.remove_prefix(std::min(rest.find_first_not_of(space), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(space));
  rest.remove_prefix(std::min(word.size() + 1, rest.size()));
  return word;
}

long long take_side(const fs::path& path, std::string_view& rest) {
  const std::string_view word = take_word(rest);
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc() || end != word.data() + word.size())
    fail(path, "has no whole numbers where a PFM has width and height; export it again");
  return value;
}

PfmHeader read_pfm_header(const fs::path& path, std::string_view bytes) {
  std::string_view rest = bytes;
  const std::string_view magic = take_word(rest);
  if (magic != "PF" && magic != "Pf")
    fail(path, "is no PFM (it does not start with PF or Pf); name a .pfm file");
  PfmHeader header;
  header.channels = magic == "PF" ? 3 : 1;
  const long long width = take_side(path, rest);
  const long long height = take_side(path, rest);
  check_size(path, width, height);
  header.width = static_cast<int>(width);
  header.height = static_cast<int>(height);

  std::istringstream scale{std::string(take_word(rest))};
  scale.imbue(std::locale::classic());
  if (!(scale >> header.scale) || scale.peek() != EOF || !std::isfinite(header.scale) ||
      header.scale == 0)
    fail(path, "has no usable scale in its third line; export it again");
  header.floats = rest;
  return header;
}

float to_float(const char* four_bytes, bool is_little_endian) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i) {
    const int shift = is_little_endian ? 8 * i : 24 - 8 * i;
    bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(four_bytes[i])) << shift;
  }
  return std::bit_cast<float>(bits);
}

}  // namespace

PixelsFloat read_pfm(const fs::path& path) {
  const std::string bytes = read_file(path, std::size_t{4} << 30);
  const PfmHeader header = read_pfm_header(path, bytes);
  const std::size_t row = static_cast<std::size_t>(header.width) * header.channels;
  const std::size_t expected = row * header.height * sizeof(float);
  if (header.floats.size() != expected)
    fail(path, "has " + std::to_string(header.floats.size()) + " bytes of pixels, not the " +
                   std::to_string(expected) + " that its header promises; export it again");

  PixelsFloat pixels{header.width, header.height, {}};
  pixels.rgb.reserve(value_count(header.width, header.height));
  const auto factor = static_cast<float>(std::abs(header.scale));
  for (int y = header.height - 1; y >= 0; --y) {  // the file's last row is the picture's first
    const char* value = header.floats.data() + row * y * sizeof(float);
    for (std::size_t i = 0; i < row; ++i, value += sizeof(float))
      pixels.rgb.insert(pixels.rgb.end(), header.channels == 3 ? 1 : 3,
                        factor * to_float(value, header.scale < 0));
  }
  return pixels;
}

void write_pfm(const fs::path& path, const PixelsFloat& pixels) {
  assert(pixels.width >= 1 && pixels.height >= 1);
  assert(pixels.rgb.size() == value_count(pixels.width, pixels.height));
  std::string file = "PF\n" + std::to_string(pixels.width) + " " + std::to_string(pixels.height) +
                     "\n-1.0\n";  // negative: little-endian
  file.reserve(file.size() + pixels.rgb.size() * sizeof(float));
  const std::size_t row = static_cast<std::size_t>(pixels.width) * 3;
  for (int y = pixels.height - 1; y >= 0; --y)
    for (std::size_t i = 0; i < row; ++i) {
      const auto bits = std::bit_cast<std::uint32_t>(pixels.rgb[row * y + i]);
      for (int shift = 0; shift < 32; shift += 8)
        file.push_back(static_cast<char>(bits >> shift & 0xff));
    }
  write_file_whole(path, file);
}

}  // namespace lt
