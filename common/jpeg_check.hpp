/// @file
/// What must be known of a JPEG before stb_image may see it. Part of pixel_io.cpp.
#pragma once

#include <string_view>

namespace lt {

/// Whether a file that starts like a JPEG also ends like one, and every Huffman table in it has at
/// most 256 symbols. stb_image paints what is missing grey, and before version 2.29 it writes the
/// symbols of a larger table beyond its arrays.
[[nodiscard]] bool is_sound_jpeg(std::string_view bytes);

}  // namespace lt
