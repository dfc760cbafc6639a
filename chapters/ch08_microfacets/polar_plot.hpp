/// @file
/// Functions of a direction as curves around a point: the longer the ray, the larger the value.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "common/plot/style.hpp"
#include "common/plot/text.hpp"

namespace lt {

/// One curve of a polar plot.
struct PolarCurve {
  std::string label;
  std::vector<double> angles;  ///< from straight up, degrees, -90 (left) to 90
  std::vector<double> radii;   ///< as many, 0 to 1: 1 touches the outer circle
};

/// What is drawn over one half of the directions in a plane.
struct PolarPlot {
  std::string title;
  std::string description;  ///< what to see, for readers who cannot see it
  std::string note;         ///< below the ground
  double wo_degrees = 0;    ///< where one looks from, to the left of straight up
  std::vector<PolarCurve> curves;
};

/// A polar plot, being drawn: 720 x 440 units like common/plot.hpp's, in the same colours.
class PolarDrawing {
 public:
  explicit PolarDrawing(const PolarPlot& plot) : plot_(plot) {}

  [[nodiscard]] std::string svg() const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 720 440\" class=\"lt-plot\" "
           "role=\"img\">\n<title>" +
           escape_xml(plot_.title) + "</title>\n<desc>" + escape_xml(plot_.description) +
           "</desc>\n" + plot_style() + grid() + words() + curves() + arrow() + "</svg>\n";
  }

 private:
  static constexpr double x_ = 290, y_ = 388, radius_ = 260;

  /// The place at an angle from straight up, degrees, "x y".
  [[nodiscard]] static std::string at(double degrees, double radius) {
    const double angle = degrees * std::numbers::pi / 180;
    return svg_number(x_ + radius_ * radius * std::sin(angle)) + " " +
           svg_number(y_ - radius_ * radius * std::cos(angle));
  }
  [[nodiscard]] static std::string text(const std::string& place, const std::string& attributes,
                                        const std::string& xml) {
    const std::size_t blank = place.find(' ');
    return "<text x=\"" + place.substr(0, blank) + "\" y=\"" + place.substr(blank + 1) + "\"" +
           attributes + ">" + xml + "</text>\n";
  }

  [[nodiscard]] static std::string grid() {
    std::string rays, circles;
    for (int degrees = -60; degrees <= 60; degrees += 30)
      rays += "M" + at(degrees, 0) + "L" + at(degrees, 1);
    for (const double radius : {0.25, 0.5, 0.75, 1.0}) {
      const std::string r = svg_number(radius_ * radius);
      circles += "M" + at(-90, radius) + "A" + r + " " + r + " 0 0 1 " + at(90, radius);
    }
    return "<path class=\"minor\" d=\"" + circles + "\"/>\n<path class=\"grid\" d=\"" + rays +
           "\"/>\n<path class=\"axis\" d=\"M" + at(-90, 1.04) + "L" + at(90, 1.04) + "\"/>\n";
  }

  [[nodiscard]] std::string words() const {
    std::string texts = text("12 29", " class=\"title\"", escape_xml(plot_.title));
    for (int degrees = -60; degrees <= 60; degrees += 30)
      if (degrees != -plot_.wo_degrees)
        texts += text(at(degrees, 1.07), " class=\"quiet\" text-anchor=\"middle\"",
                      std::to_string(std::abs(degrees)) + "\u00b0");
    return texts + text(svg_number(x_) + " 420", " class=\"quiet\" text-anchor=\"middle\"",
                        escape_xml(plot_.note));
  }

  [[nodiscard]] std::string curves() const {
    std::string all;
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
      const PolarCurve& curve = plot_.curves[i];
      std::string path;
      for (std::size_t p = 0; p < curve.angles.size(); ++p)
        path += (p == 0 ? "M" : "L") + at(curve.angles[p], curve.radii[p]);
      const double y = 120 + 58 * static_cast<double>(i);
      all += "<g class=\"" + curve_class(i) + "\">\n<path class=\"curve\" d=\"" + path + "\"/>\n" +
             "<path class=\"curve\" d=\"M590 " + svg_number(y - 7) + "H612\"/>\n";
      double line_y = y;
      for (const std::string& line : wrap(curve.label, 100)) {
        all += text("620 " + svg_number(line_y), "", escape_xml(line));
        line_y += line_height;
      }
      all += "</g>\n";
    }
    return all;
  }

  /// From the surface to whoever looks.
  [[nodiscard]] std::string arrow() const {
    const double a = -plot_.wo_degrees;
    return "<path class=\"axis\" d=\"M" + at(a, 0) + "L" + at(a, 0.98) + "M" + at(a - 2, 0.93) +
           "L" + at(a, 0.98) + "L" + at(a + 2, 0.93) + "\"/>\n" +
           text(at(a, 1.07), " text-anchor=\"middle\"", "wo");
  }

  const PolarPlot& plot_;
};

/// The plot as a complete SVG document; follows prefers-color-scheme.
[[nodiscard]] inline std::string to_svg(const PolarPlot& plot) {
  return PolarDrawing(plot).svg();
}

}  // namespace lt
