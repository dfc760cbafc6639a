/// @file
/// The sRGB curve as plots.
#pragma once

#include "ch01_pixels/color.hpp"
#include "common/plot.hpp"

namespace lt {

/// Codes against light: the curve, and what equal steps of light would be.
[[nodiscard]] inline Plot curve_plot() {
  Plot plot;
  plot.title = "From light to code";
  plot.x_label = "light (1 = white)";
  plot.y_label = "code";
  plot.description =
      "The sRGB curve rises steeply in the dark and flattens: half the light of white has code "
      "188, "
      "and half of the codes lie below 22 percent of it. A straight line is drawn beside it.";
  Series curve{"sRGB", {}, {}};
  for (int i = 0; i <= 400; ++i) {
    const float signal = static_cast<float>(i) / 400.0f;
    curve.add(decode_srgb(signal), 255.0 * signal);
  }
  plot.series = {curve, {"equal steps of light", {0.0, 1.0}, {0.0, 255.0}}};
  return plot;
}

/// The jump from one code to the next as a share of the light there.
[[nodiscard]] inline Plot step_plot() {
  Plot plot;
  plot.title = "How much brighter is the next code?";
  plot.x_label = "light (1 = white)";
  plot.y_label = "step (percent of that light)";
  plot.log_x = true;
  plot.log_y = true;
  plot.description =
      "On logarithmic axes. Linear codes, at equal steps of light, fall from 100 percent in the "
      "dark "
      "to 0.4 percent at white. sRGB codes fall from 100 percent to 0.9 percent: 13 times finer in "
      "the deepest dark, as fine at a quarter of white, coarser above. A level line marks the 1 "
      "percent that an eye can just see.";
  Series equal{"linear codes", {}, {}};
  Series srgb{"sRGB codes", {}, {}};
  for (int code = 1; code < 255; ++code) {
    equal.add(code / 255.0, 100.0 / code);
    const double here = from_code(static_cast<std::uint8_t>(code));
    const double next = from_code(static_cast<std::uint8_t>(code + 1));
    srgb.add(here, 100.0 * (next - here) / here);
  }
  plot.series = {srgb, equal, {"just visible: 1 %", {0.0003, 1.0}, {1.0, 1.0}}};
  return plot;
}

}  // namespace lt
