/// @file
/// Labels at the ends of lines, moved apart where they would overlap. Part of plot.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lt {

/// The label of one curve.
struct EndLabel {
  std::size_t series = 0;
  std::vector<std::string> lines;
  double end_x = 0;     ///< where the curve ends
  double end_y = 0;     ///< and where the label's middle belongs
  double before_y = 0;  ///< where the curve comes from: orders labels of curves that meet
  double y = 0;         ///< where the label's middle comes to stand

  [[nodiscard]] double height() const;
};

/// Sorts the labels from the top down and moves them as little as possible (least squares), so
/// that none overlap and all stand between `top` and `bottom` if there is room.
void move_apart(std::vector<EndLabel>& labels, double top, double bottom);

}  // namespace lt
