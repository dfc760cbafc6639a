// Bytes of picture files for the tests: good ones of kinds that we never write, and bad ones.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

extern "C" int stbi_write_jpg_to_func(void (*write)(void*, void*, int), void* context, int width,
                                      int height, int channels, const void* data, int quality);

namespace lt::test {

inline std::string from_hex(std::string_view hex) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<char>(digit(hex[i]) * 16 + digit(hex[i + 1])));
  return bytes;
}

/// A progressive JPEG of 8 x 8 pixels, all (200, 100, 50), made with libjpeg's cjpeg.
inline std::string progressive_jpeg() {
  return from_hex(
      "ffd8ffe000104a46494600010100000100010000ffdb004300080606070605080707070909080a0c140d0c0b"
      "0b0c1912130f141d1a1f1e1d1a1c1c20242e2720222c231c1c2837292c30313434341f27393d38323c2e3334"
      "32ffdb0043010909090c0b0c180d0d1832211c21323232323232323232323232323232323232323232323232"
      "3232323232323232323232323232323232323232323232323232ffc200110800080008030122000211010311"
      "01ffc4001500010100000000000000000000000000000002ffc4001401010000000000000000000000000000"
      "0005ffda000c0301000210031000000190631fffc40014100100000000000000000000000000000000ffda00"
      "080101000105027fffc40014110100000000000000000000000000000000ffda0008010301013f017fffc400"
      "14110100000000000000000000000000000000ffda0008010201013f017fffc4001410010000000000000000"
      "0000000000000000ffda0008010100063f027fffc40014100100000000000000000000000000000000ffda00"
      "08010100013f217fffda000c030100020003000000100bffc400141101000000000000000000000000000000"
      "00ffda0008010301013f107fffc40014110100000000000000000000000000000000ffda0008010201013f10"
      "7fffc40014100100000000000000000000000000000000ffda0008010100013f107fffd9");
}

/// A baseline JPEG of a gradient.
inline std::string baseline_jpeg(int width, int height) {
  std::vector<std::uint8_t> codes;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int code : {x * 255 / width, y * 255 / height, 128})
        codes.push_back(static_cast<std::uint8_t>(code));
  std::string jpeg;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  stbi_write_jpg_to_func(append, &jpeg, width, height, 3, codes.data(), 80);
  return jpeg;
}

inline std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<char>(value >> shift & 0xff));
  return bytes;
}

/// The cyclic redundancy check of PNG's chunks (ISO 3309), bit by bit.
inline std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit)
      crc = (crc & 1) != 0 ? 0xedb88320u ^ crc >> 1 : crc >> 1;
  }
  return ~crc;
}

inline std::string png_chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
         big_endian(crc32(type + data));
}

/// zlib data without compression: one stored block.
inline std::string zlib_stored(std::string_view data) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<unsigned>(data.size());
  std::string bytes = "\x78\x01\x01";
  for (const unsigned n : {size, ~size}) {
    bytes.push_back(static_cast<char>(n & 0xff));
    bytes.push_back(static_cast<char>(n >> 8 & 0xff));
  }
  return bytes + std::string(data) + big_endian(b << 16 | a);
}

enum class PngColor : char { grey = 0, rgb = 2, grey_alpha = 4, rgba = 6 };

/// A PNG whose header says what you like. `rows`: a filter byte 0, then the codes, for each row.
inline std::string png_of(std::uint32_t width, std::uint32_t height, int bits, PngColor color,
                          const std::string& rows) {
  const std::string header = big_endian(width) + big_endian(height) + static_cast<char>(bits) +
                             static_cast<char>(color) + std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + png_chunk("IDAT", zlib_stored(rows)) +
         png_chunk("IEND", "");
}

}  // namespace lt::test
