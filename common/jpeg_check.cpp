#include "common/jpeg_check.hpp"

namespace lt {

namespace {

// Second bytes of markers (ITU-T T.81, table B.1). The first is ff.
constexpr unsigned huffman_tables = 0xc4;
constexpr unsigned restart_0 = 0xd0;
constexpr unsigned start_of_image = 0xd8;
constexpr unsigned end_of_image = 0xd9;
constexpr unsigned fill = 0xff;

unsigned byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

// The tables of one segment: a class and number, 16 counts of symbols, the symbols.
bool are_sound_tables(std::string_view tables) {
  while (!tables.empty()) {
    if (tables.size() < 17) return false;
    std::size_t symbols = 0;
    for (std::size_t i = 1; i <= 16; ++i)
      symbols += byte_at(tables, i);
    if (symbols > 256 || tables.size() < 17 + symbols) return false;
    tables.remove_prefix(17 + symbols);
  }
  return true;
}

}  // namespace

bool is_sound_jpeg(std::string_view bytes) {
  std::size_t at = 0;
  while ((at = bytes.find('\xff', at)) != bytes.npos && at + 1 < bytes.size()) {
    const unsigned marker = byte_at(bytes, at + 1);
    if (marker == end_of_image) return true;
    if (marker == fill) {
      at += 1;
    } else if (marker == 0 || (marker >= restart_0 && marker <= start_of_image)) {
      at += 2;  // compressed data goes on
    } else {
      // A segment with its length, which counts itself.
      if (at + 4 > bytes.size()) return false;
      const std::size_t length = byte_at(bytes, at + 2) << 8 | byte_at(bytes, at + 3);
      if (length < 2 || at + 2 + length > bytes.size()) return false;
      if (marker == huffman_tables && !are_sound_tables(bytes.substr(at + 4, length - 2)))
        return false;
      at += 2 + length;
    }
  }
  return false;
}

}  // namespace lt
