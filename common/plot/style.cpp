#include "common/plot/style.hpp"

#include <array>
#include <string_view>

#include "common/plot/text.hpp"

namespace lt {

namespace {

struct Color {
  std::string_view on_light, on_dark;
};

// Hues after Okabe and Ito (2008). Lightness chosen so that each has a contrast of at least 4.5 to
// its page (labels wear them too) and any two stay apart for every kind of color vision: a test
// measures both.
constexpr std::array<Color, 6> curve_colors = {{{"#0b62c4", "#4aa3ff"},
                                                {"#c04e0a", "#f27a2d"},
                                                {"#126a50", "#5fe3bd"},
                                                {"#c23aa0", "#cf7fb4"},
                                                {"#574500", "#ffe15a"},
                                                {"#1f2328", "#ffffff"}}};
constexpr Color ink = {"#1f2328", "#e6edf3"};
constexpr Color quiet_ink = {"#57606a", "#a3acb6"};
constexpr Color grid = {"#d3d9df", "#3b424b"};
constexpr Color minor_grid = {"#e6eaee", "#292f37"};

std::string rule(std::string_view selector, std::string_view properties) {
  return ".lt-plot " + std::string(selector) + "{" + std::string(properties) + "}";
}

std::string rule(std::string_view selector, std::string_view property, std::string_view color) {
  return rule(selector, std::string(property) + ":" + std::string(color));
}

// The rules that differ between a light and a dark page.
std::string color_rules(bool is_dark) {
  const auto pick = [is_dark](const Color& c) { return is_dark ? c.on_dark : c.on_light; };
  std::string css = rule("text", "fill", pick(ink)) + rule(".quiet", "fill", pick(quiet_ink)) +
                    rule(".axis", "stroke", pick(quiet_ink)) + rule(".grid", "stroke", pick(grid)) +
                    rule(".minor", "stroke", pick(minor_grid));
  for (std::size_t i = 0; i < curve_colors.size(); ++i) {
    const std::string name = "." + curve_class(i);
    css += rule(name, "stroke", pick(curve_colors[i])) +
           rule(name + " text", "fill", pick(curve_colors[i])) +
           rule(name + " circle", "fill", pick(curve_colors[i]));
  }
  return css;
}

}  // namespace

std::string curve_class(std::size_t n) {
  return "c" + std::to_string(n % curve_colors.size());
}

std::string plot_style() {
  return "<style>.lt-plot{font-family:system-ui,-apple-system,'Segoe UI',sans-serif;font-size:" +
         svg_number(font_size) + "px}" + rule("text", "stroke:none") + rule("path", "fill:none") +
         rule(".title", "font-weight:600") + rule(".grid", "stroke-width:1.2") +
         rule(".minor", "stroke-width:1") + rule(".axis", "stroke-width:1.5") +
         rule(".curve", "stroke-width:3;stroke-linejoin:round;stroke-linecap:round") +
         rule(".leader", "stroke-width:1.5;stroke-dasharray:1.5 4") + color_rules(false) +
         "@media (prefers-color-scheme:dark){" + color_rules(true) + "}</style>\n";
}

}  // namespace lt
