/// @file
/// Is a stored picture still the one that the code makes?
#pragma once

#include <filesystem>
#include <string>

#include "common/pixel_io.hpp"

namespace lt::house {

/// How two pictures of one size differ.
struct PixelDifference {
  double mean_codes;     ///< mean of |a - b| over all codes, 0 to 255
  double far_off_share;  ///< share of pixels in which a code differs by more than 8
};

/// @pre equal sizes, not empty
[[nodiscard]] PixelDifference difference(const Pixels8& a, const Pixels8& b);

/// What tells a stored picture from a fresh one, in words; empty if they are the same. Compilers
/// differ in the last bit of a float, which can move a code by one and an edge by a pixel: a PNG
/// may differ by one code in the mean and by more than 8 codes in one pixel of a thousand. An SVG
/// is the same text or another picture.
[[nodiscard]] std::string drift(const std::filesystem::path& stored,
                                const std::filesystem::path& fresh);

}  // namespace lt::house
