/// @file
/// Picture files as plain arrays. What the numbers *mean* is chapter 1's business
/// (`ch01_pixels/image_file.hpp`).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace lt {

/// The largest width or height that a picture file may have, in pixels.
inline constexpr int max_image_side = 16384;

/// 8-bit codes, three per pixel (red, green, blue), row by row from the top, left to right.
struct Pixels8 {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< width * height * 3 codes, 0 to 255
};

/// Linear radiance, three floats per pixel, row by row from the top, left to right.
struct PixelsFloat {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;  ///< width * height * 3 values
};

/// Reads a PNG or JPEG; grey becomes three equal codes, transparency is dropped.
/// @throws InputError  missing, not such a file, truncated, or wider or higher than max_image_side
[[nodiscard]] Pixels8 read_pixels8(const std::filesystem::path& path);

/// Writes a PNG, whole or not at all.
/// @throws OutputError  the file cannot be written
void write_png(const std::filesystem::path& path, const Pixels8& pixels);

/// Reads a colour or grey PFM ("PF"/"Pf"), either byte order; the file's rows, which go from the
/// bottom up, are turned to go from the top.
/// @throws InputError  missing, not a PFM, truncated, or wider or higher than max_image_side
[[nodiscard]] PixelsFloat read_pfm(const std::filesystem::path& path);

/// Writes a little-endian colour PFM, whole or not at all.
/// @throws OutputError  the file cannot be written
void write_pfm(const std::filesystem::path& path, const PixelsFloat& pixels);

}  // namespace lt
