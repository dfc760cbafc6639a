/// @file
/// The pictures that the program offers, by name.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ch01_pixels/evening.hpp"
#include "ch01_pixels/galaxy.hpp"
#include "ch01_pixels/mistakes.hpp"
#include "ch01_pixels/patterns.hpp"
#include "common/error.hpp"
#include "common/pixel_io.hpp"

namespace lt {

/// What to paint.
struct ViewOptions {
  std::string name = "evening";  ///< evening, checker, gradient, glow, ramp or galaxy
  int width = 900;               ///< pixels, >= 1
  int height = 720;              ///< pixels, >= 1
  float stops = 0.0f;            ///< exposure: light times 2 to the power of this
  bool wrong = false;            ///< with the mistake that the text shows; not for patterns
};

/// The light of `image`, times 2^stops.
[[nodiscard]] inline Image exposed(Image image, float stops) {
  const float factor = std::exp2(stops);
  return changed(std::move(image), [factor](float linear) { return factor * linear; });
}

/// Paints four times as wide and high, so that halving it twice gives smooth edges.
/// @throws InputError  that would be larger than a picture may be
[[nodiscard]] inline Image fine_view(const ViewOptions& view) {
  if (std::max(view.width, view.height) > max_image_side / 4)
    throw InputError("--width, --height: " + view.name + " is painted at four times its size; " +
                     std::to_string(max_image_side / 4) + " is the most");
  const int width = 4 * view.width;
  const int height = 4 * view.height;
  return exposed(view.name == "galaxy" ? galaxy(width, height) : evening_picture(width, height),
                 view.stops);
}

/// The picture that `view` asks for.
/// @throws InputError  `wrong` is asked of a pattern that shows right and wrong already
[[nodiscard]] inline Image make_view(const ViewOptions& view) {
  const std::string& name = view.name;
  if (name == "galaxy")
    return view.wrong ? halve_codes(halve_codes(fine_view(view))) : halve(halve(fine_view(view)));
  if (name == "evening") {
    const Image image = halve(halve(fine_view(view)));
    return view.wrong ? stored_without_encoding(image) : image;
  }
  if (name == "glow") {
    const Image image = exposed(glow(view.width, view.height), view.stops);
    return view.wrong ? in_linear_codes(image) : image;
  }
  if (view.wrong)
    throw InputError("--wrong is for the views evening, glow and galaxy; leave it out for " + name);
  const auto pattern = name == "checker" ? checker : name == "gradient" ? gradient : ramp;
  return exposed(pattern(view.width, view.height), view.stops);
}

}  // namespace lt
