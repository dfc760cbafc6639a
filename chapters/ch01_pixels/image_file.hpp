/// @file
/// Pictures to and from files: PNG for people (sRGB codes), PFM for numbers (linear radiance).
#pragma once

#include <array>
#include <filesystem>

#include "ch01_pixels/image.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/pixel_io.hpp"

namespace lt {

// [to-codes]
/// The picture as 8-bit sRGB codes, row by row from the top.
[[nodiscard]] inline Pixels8 to_codes(const Image& image) {
  Pixels8 codes{image.width(), image.height(), {}};
  codes.rgb.reserve(static_cast<std::size_t>(image.width()) * image.height() * 3);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c)
        codes.rgb.push_back(to_code(image.at(x, y)[c]));
  return codes;
}
// [to-codes]

/// The picture's numbers as they are, row by row from the top.
[[nodiscard]] inline PixelsFloat to_floats(const Image& image) {
  PixelsFloat floats{image.width(), image.height(), {}};
  floats.rgb.reserve(static_cast<std::size_t>(image.width()) * image.height() * 3);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c)
        floats.rgb.push_back(image.at(x, y)[c]);
  return floats;
}

// [from-codes]
/// The linear picture behind 8-bit sRGB codes, row by row from the top.
[[nodiscard]] inline Image from_codes(const Pixels8& codes) {
  // There are only 256 answers: work them out once, not once for each pixel.
  std::array<float, 256> light;
  for (std::size_t code = 0; code < light.size(); ++code)
    light[code] = from_code(static_cast<std::uint8_t>(code));

  Image image(codes.width, codes.height);
  const std::uint8_t* code = codes.rgb.data();
  for (int y = 0; y < codes.height; ++y)
    for (int x = 0; x < codes.width; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = light[*code++];
  return image;
}
// [from-codes]

/// @throws InputError  `path` does not end in ".png" or ".pfm"
inline void require_picture_path(const std::filesystem::path& path) {
  if (path.extension() == ".png" || path.extension() == ".pfm") return;
  throw InputError("--out: " + printable(path.string()) + " is no picture; end it in .png or .pfm");
}

// [save-image]
/// Writes `image` as the extension says: codes into a ".png", the numbers as they are into a
/// ".pfm".
/// @throws InputError   another extension
/// @throws OutputError  the file cannot be written; an older file of that name is intact
inline void save_image(const std::filesystem::path& path, const Image& image) {
  require_picture_path(path);
  if (path.extension() == ".png")
    write_png(path, to_codes(image));
  else
    write_pfm(path, to_floats(image));
}
// [save-image]

}  // namespace lt
