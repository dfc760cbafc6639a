/// @file
/// Colors and style sheet of a plot, for a light and for a dark page. Part of plot.cpp.
#pragma once

#include <string>

namespace lt {

/// The class that gives the n-th curve, its points and its label their color: "c0", "c1", ...
[[nodiscard]] std::string curve_class(std::size_t n);

/// The <style> element. All rules are for elements inside class "lt-plot".
[[nodiscard]] std::string plot_style();

}  // namespace lt
