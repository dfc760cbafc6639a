/// @file
/// One axis of a plot: which numbers it spans and where its ticks are. Part of plot.cpp.
#pragma once

#include <string>
#include <vector>

namespace lt {

/// A labelled tick: `text`, then `exponent` raised, e.g. "10" and "3".
struct Tick {
  double value;
  std::string text;
  std::string exponent;
};

/// An axis with its range and ticks. On a logarithmic axis every value is > 0.
struct Axis {
  bool is_log = false;
  double low = 0;   ///< value at the start
  double high = 1;  ///< value at the end, > low
  std::vector<Tick> ticks;
  std::vector<double> minor;  ///< values of unlabelled lines

  /// Where `value` lies: 0 at the start, 1 at the end.
  [[nodiscard]] double share(double value) const;
};

/// True if `value` can be drawn on such an axis.
[[nodiscard]] bool is_drawable(double value, bool is_log);

/// The axis for `values`, those that can be drawn; 0 to 1 (or 1 to 10) if there are none.
/// @param round_out   widen the range to the nearest ticks
/// @param most_ticks  about how many labelled ticks there is room for, >= 2
[[nodiscard]] Axis make_axis(const std::vector<double>& values, bool is_log, bool round_out,
                             int most_ticks);

}  // namespace lt
