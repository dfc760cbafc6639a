/// @file
/// Line plots as SVG: dark and light, linear or logarithmic axes, labels at the lines.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace lt {

/// One curve of a plot.
struct Series {
  std::string label;      ///< written at the end of the line
  std::vector<double> x;  ///< as many as y
  std::vector<double> y;  ///< non-finite values leave a gap
  bool show_line = true;
  bool show_points = false;
  int color_of = -1;  ///< wears the color of the series of this number; -1: its own

  void add(double x_value, double y_value) {
    x.push_back(x_value);
    y.push_back(y_value);
  }
};

/// A plot with its axes.
struct Plot {
  std::string title;
  std::string x_label;      ///< with its unit
  std::string y_label;      ///< with its unit
  bool log_x = false;       ///< values <= 0 are left out
  bool log_y = false;       ///< values <= 0 are left out
  std::string description;  ///< what to see, for readers who cannot see it (SVG <desc>)
  std::vector<Series> series;
};

/// Adds what was measured as dots and what is expected there as a labelled line, in one color.
/// @param measured  its points; label and looks do not count
/// @param expected  called with each x of `measured`
void add_dots_and_line(Plot& plot, Series measured, const std::string& label,
                       const std::function<double(double x)>& expected);

/// The plot as a complete SVG document, 720 x 440 units, legible at phone width; follows
/// prefers-color-scheme.
[[nodiscard]] std::string to_svg(const Plot& plot);

/// @throws InputError  `path` does not end in ".svg"
void require_plot_path(const std::filesystem::path& path);

}  // namespace lt
