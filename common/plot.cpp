#include "common/plot.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>

#include "common/plot/axis.hpp"
#include "common/plot/end_labels.hpp"
#include "common/plot/style.hpp"
#include "common/plot/text.hpp"

namespace lt {

namespace {

// All lengths are in units of the viewBox.
constexpr double full_width = 720;
constexpr double full_height = 440;
constexpr double border = 12;
constexpr double widest_label = 190;

std::string attribute(std::string_view name, double value) {
  return " " + std::string(name) + "=\"" + svg_number(value) + "\"";
}

std::string text(double x, double y, std::string_view attributes, const std::string& xml) {
  return "<text" + attribute("x", x) + attribute("y", y) + std::string(attributes) + ">" + xml +
         "</text>\n";
}

std::string tick_text(const Tick& tick) {
  if (tick.exponent.empty()) return tick.text;
  return tick.text + "<tspan dy=\"-8\" font-size=\"15\">" + tick.exponent + "</tspan>";
}

double tick_width(const Tick& tick) {
  return text_width(tick.text) + text_width(tick.exponent) * 15 / font_size;
}

// A plot being drawn: margins first, then the axes, then the curves and their labels.
class Drawing {
 public:
  explicit Drawing(const Plot& plot) : plot_(plot) {
    title_ = wrap(plot.title, 0.9 * (full_width - 2 * border));  // its letters are bold
    const auto lines_above = static_cast<double>(title_.size() + (plot.y_label.empty() ? 0 : 1));
    top_ = border + line_height * lines_above + 17;
    bottom_ = full_height - border - line_height * (plot.x_label.empty() ? 1 : 2) - 9;
    make_axes();
    place_labels();
  }

  [[nodiscard]] std::string svg() const {
    std::string curves;
    for (std::size_t s = 0; s < plot_.series.size(); ++s)
      curves += "<g class=\"" + class_of(s) + "\">\n" + curve(plot_.series[s]) + "</g>\n";
    std::string labels;
    for (const EndLabel& label : labels_)
      labels += "<g class=\"" + class_of(label.series) + "\">\n" + end_label(label) + "</g>\n";
    return head() + plot_style() + grid() + titles() + tick_texts() + curves + labels + "</svg>\n";
  }

 private:
  [[nodiscard]] std::string class_of(std::size_t s) const {
    const int other = plot_.series[s].color_of;
    return curve_class(other < 0 ? s : static_cast<std::size_t>(other));
  }
  [[nodiscard]] bool is_visible(const Series& series, std::size_t i) const {
    return i < series.x.size() && is_drawable(series.x[i], plot_.log_x) &&
           is_drawable(series.y[i], plot_.log_y);
  }
  [[nodiscard]] double x_at(double value) const {
    return left_ + (right_ - left_) * x_.share(value);
  }
  [[nodiscard]] double y_at(double value) const {
    return bottom_ - (bottom_ - top_) * y_.share(value);
  }

  void make_axes() {
    std::vector<double> xs;
    std::vector<double> ys;
    double label_width = 20;
    for (const Series& series : plot_.series) {
      assert(series.x.size() == series.y.size());
      for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!is_visible(series, i)) continue;
        xs.push_back(series.x[i]);
        ys.push_back(series.y[i]);
      }
      for (const std::string& line : wrap(series.label, widest_label))
        label_width = std::max(label_width, text_width(line));
    }
    y_ = make_axis(ys, plot_.log_y, true, 5);
    double tick_label_width = 0;
    for (const Tick& tick : y_.ticks)
      tick_label_width = std::max(tick_label_width, tick_width(tick));
    left_ = border + tick_label_width + 9;
    right_ = full_width - border - label_width - 14;
    // As many ticks as have room for their labels.
    for (int most_ticks = 6; most_ticks >= 2; --most_ticks) {
      x_ = make_axis(xs, plot_.log_x, false, most_ticks);
      double needed = 0;
      for (const Tick& tick : x_.ticks)
        needed += tick_width(tick) + 18;
      if (needed <= right_ - left_) break;
    }
    is_empty_ = xs.empty();
  }

  // The label of a series belongs to its rightmost point.
  void place_labels() {
    for (std::size_t s = 0; s < plot_.series.size(); ++s) {
      const Series& series = plot_.series[s];
      EndLabel label{s, wrap(series.label, widest_label), -1, 0, 0, 0};
      for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!is_visible(series, i) || x_at(series.x[i]) < label.end_x) continue;
        label.end_x = x_at(series.x[i]);
        label.end_y = label.before_y = y_at(series.y[i]);
      }
      double before_x = -1;
      for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!is_visible(series, i)) continue;
        const double x = x_at(series.x[i]);
        if (x < before_x || x > label.end_x - 40) continue;
        before_x = x;
        label.before_y = y_at(series.y[i]);
      }
      if (label.end_x >= 0 && !label.lines.empty()) labels_.push_back(label);
    }
    move_apart(labels_, top_ - line_height / 2, bottom_ + line_height / 2);
  }

  [[nodiscard]] std::string head() const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + svg_number(full_width) +
           " " + svg_number(full_height) + "\" class=\"lt-plot\" role=\"img\">\n<title>" +
           escape_xml(plot_.title) + "</title>\n<desc>" + escape_xml(plot_.description) +
           "</desc>\n";
  }

  [[nodiscard]] std::string grid() const {
    const auto across = [&](double y) {
      return "M" + svg_number(left_) + " " + svg_number(y) + "H" + svg_number(right_);
    };
    const auto up = [&](double x) {
      return "M" + svg_number(x) + " " + svg_number(top_) + "V" + svg_number(bottom_);
    };
    std::string minor;
    std::string major;
    for (const double value : x_.minor)
      minor += up(x_at(value));
    for (const double value : y_.minor)
      minor += across(y_at(value));
    for (const Tick& tick : x_.ticks)
      major += up(x_at(tick.value));
    for (const Tick& tick : y_.ticks)
      major += across(y_at(tick.value));
    return "<path class=\"minor\" d=\"" + minor + "\"/>\n<path class=\"grid\" d=\"" + major +
           "\"/>\n<path class=\"axis\" d=\"" + across(bottom_) + "\"/>\n";
  }

  [[nodiscard]] std::string titles() const {
    constexpr std::string_view centred = " class=\"quiet\" text-anchor=\"middle\"";
    const double middle = (left_ + right_) / 2;
    std::string texts;
    double y = border + 17;
    for (const std::string& line : title_) {
      texts += text(border, y, " class=\"title\"", escape_xml(line));
      y += line_height;
    }
    texts += text(border, y + 2, " class=\"quiet\"", escape_xml(plot_.y_label));
    texts += text(middle, full_height - border, centred, escape_xml(plot_.x_label));
    if (is_empty_) texts += text(middle, (top_ + bottom_) / 2, centred, "no data");
    return texts;
  }

  [[nodiscard]] std::string tick_texts() const {
    std::string texts;
    for (const Tick& tick : y_.ticks)
      texts += text(left_ - 9, y_at(tick.value) + 7, " class=\"quiet\" text-anchor=\"end\"",
                    tick_text(tick));
    for (const Tick& tick : x_.ticks)
      texts += text(x_at(tick.value), bottom_ + 26, " class=\"quiet\" text-anchor=\"middle\"",
                    tick_text(tick));
    return texts;
  }

  // The line, in runs of neighbours that are visible; a run of one point becomes a dot.
  [[nodiscard]] std::string curve(const Series& series) const {
    std::string path;
    std::string dots;
    std::string before;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!is_visible(series, i)) continue;
      const double x = x_at(series.x[i]);
      const double y = y_at(series.y[i]);
      const bool starts = i == 0 || !is_visible(series, i - 1);
      const bool is_alone = starts && !is_visible(series, i + 1);
      const std::string place = svg_number(x) + " " + svg_number(y);
      if (starts || place != before) path += (starts ? "M" : "L") + place;
      if (series.show_points || is_alone)
        dots += "<circle" + attribute("cx", x) + attribute("cy", y) + " r=\"4.5\"/>\n";
      before = place;
    }
    return (series.show_line ? "<path class=\"curve\" d=\"" + path + "\"/>\n" : "") + dots;
  }

  // The words, and a dotted line to them if they do not stand at the curve's end.
  [[nodiscard]] std::string end_label(const EndLabel& label) const {
    std::string svg;
    if (std::abs(label.y - label.end_y) > 4 || right_ - label.end_x > 4)
      svg += "<path class=\"leader\" d=\"M" + svg_number(label.end_x + 5) + " " +
             svg_number(label.end_y) + "H" + svg_number(right_) + "L" + svg_number(right_ + 11) +
             " " + svg_number(label.y) + "\"/>\n";
    double y = label.y - label.height() / 2 + 18;
    for (const std::string& line : label.lines) {
      svg += text(right_ + 14, y, "", escape_xml(line));
      y += line_height;
    }
    return svg;
  }

  const Plot& plot_;
  std::vector<std::string> title_;
  double top_ = 0;
  double bottom_ = 0;
  double left_ = 0;
  double right_ = 0;
  bool is_empty_ = false;
  Axis x_;
  Axis y_;
  std::vector<EndLabel> labels_;
};

}  // namespace

std::string to_svg(const Plot& plot) {
  return Drawing(plot).svg();
}

}  // namespace lt
