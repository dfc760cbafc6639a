#include "tests/house/picture_compare.hpp"

#include <algorithm>
#include <cstdlib>

#include "common/files.hpp"

namespace lt::house {
namespace {

constexpr double most_mean_codes = 1.0;
constexpr int far_off_codes = 8;
constexpr double most_far_off_share = 0.001;

std::string size_of(const Pixels8& pixels) {
  return std::to_string(pixels.width) + " x " + std::to_string(pixels.height);
}

}  // namespace

PixelDifference difference(const Pixels8& a, const Pixels8& b) {
  double sum = 0;
  int far_off = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    int largest = 0;
    for (std::size_t channel = i; channel < i + 3; ++channel) {
      const int codes = std::abs(a.rgb[channel] - b.rgb[channel]);
      sum += codes;
      largest = std::max(largest, codes);
    }
    far_off += largest > far_off_codes ? 1 : 0;
  }
  const auto codes = static_cast<double>(a.rgb.size());
  return {sum / codes, far_off / (codes / 3)};
}

std::string drift(const std::filesystem::path& stored, const std::filesystem::path& fresh) {
  if (stored.extension() != ".png") {
    return read_file(stored) == read_file(fresh) ? "" : "its text has changed";
  }
  const Pixels8 old = read_pixels8(stored);
  const Pixels8 now = read_pixels8(fresh);
  if (old.width != now.width || old.height != now.height) {
    return "is " + size_of(old) + ", and the program makes " + size_of(now);
  }
  const PixelDifference found = difference(old, now);
  if (found.mean_codes > most_mean_codes) {
    return "differs by " + std::to_string(found.mean_codes) + " codes in the mean";
  }
  if (found.far_off_share > most_far_off_share) {
    return "differs in " + std::to_string(100 * found.far_off_share) + " % of its pixels";
  }
  return "";
}

}  // namespace lt::house
