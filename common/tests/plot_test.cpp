#include "common/plot.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <regex>

#include "common/plot/end_labels.hpp"
#include "common/plot/style.hpp"
#include "common/plot/text.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/exercise.hpp"
#include "common/tests/temporary_folder.hpp"
#include "common/tests/xml.hpp"

using namespace lt::test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

lt::Plot plot_of(const std::vector<lt::Series>& series) {
  return {"Title", "x", "y", false, false, "What to see.", series};
}

// Every match of a pattern's first group.
std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

std::vector<std::string> curves(const std::string& svg) {
  return all_matches(svg, "class=\"curve\" d=\"([^\"]*)\"");
}

std::size_t count(const std::string& text, const std::string& part) {
  return all_matches(text, "(" + part + ")").size();
}

std::string problem(const std::string& svg) {
  return XmlCheck(svg).problem();
}

}  // namespace

TEST_CASE("xml check: sees what is not well-formed") {
  CHECK(problem("<a b=\"c\"><d/>t &amp; u</a>\n").empty());
  for (const char* bad : {"<a>", "<a></b>", "</a>", "<a b=c></a>", "<a b=\"<\"></a>", "<a>&</a>",
                          "<a>\x01</a>", "<a></a><b></b>", "text", "<a b=\"1\" b=\"2\"/>", "<a"})
    CHECK_FALSE(problem(bad).empty());
}

TEST_CASE("plot: a complete, well-formed SVG with title and description") {
  const std::string svg = lt::to_svg(plot_of({{"curve", {0, 1, 2}, {1, 4, 2}}}));
  CHECK(problem(svg).empty());
  CHECK(svg.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 720 440\"", 0) == 0);
  CHECK(contains(svg, "<title>Title</title>"));
  CHECK(contains(svg, "<desc>What to see.</desc>"));
  CHECK(contains(svg, "@media (prefers-color-scheme:dark)"));
  CHECK(contains(svg, ">curve</text>"));
  CHECK_FALSE(contains(svg, "nan"));
  CHECK_FALSE(contains(svg, "inf"));
}

TEST_CASE("plot: markup and control characters in words are made harmless") {
  lt::Plot plot = plot_of({{"<b>\"1\" & 'two'\n\x01</b>", {0, 1}, {0, 1}}});
  plot.title = plot.x_label = plot.y_label = plot.description = "a < b && c > \"d\" ]]>";
  const std::string svg = lt::to_svg(plot);
  CHECK(problem(svg).empty());
  CHECK(contains(svg, "a &lt; b &amp;&amp; c &gt; &quot;d&quot; ]]&gt;"));
}

TEST_CASE("plot: every word is at least 15 units high, to be read on a phone") {
  lt::Plot plot = plot_of({{"curve", {1e-9, 1}, {1e-9, 1}}});
  plot.log_x = plot.log_y = true;
  const auto sizes = all_matches(lt::to_svg(plot), "font-size[:=]\"?([0-9.]+)");
  REQUIRE_FALSE(sizes.empty());
  for (const std::string& size : sizes)
    CHECK(std::stod(size) >= 15);
}

TEST_CASE("plot: values that are not finite leave a gap") {
  const auto paths =
      curves(lt::to_svg(plot_of({{"", {0, 1, 2, 3, 4, 5}, {0, 1, not_a_number, 2, INFINITY, 3}}})));
  REQUIRE(paths.size() == 1);
  CHECK(count(paths[0], "M") == 3);
  CHECK(count(paths[0], "L") == 1);
}

TEST_CASE("plot: a logarithmic axis leaves out what is not above zero") {
  lt::Plot plot = plot_of({{"", {-1, 0, 1, 10, 100}, {5, 5, 5, 0, 50}}});
  plot.log_x = plot.log_y = true;
  const auto paths = curves(lt::to_svg(plot));
  REQUIRE(paths.size() == 1);
  CHECK(count(paths[0], "M") == 2);  // x = 1 and x = 100, with a gap between
  CHECK(count(paths[0], "L") == 0);
}

TEST_CASE("plot: a point alone is a dot, points are drawn where asked for") {
  CHECK(count(lt::to_svg(plot_of({{"", {3}, {4}}})), "<circle") == 1);
  CHECK(count(lt::to_svg(plot_of({{"", {1, 2, 3}, {1, 2, 3}}})), "<circle") == 0);
  CHECK(count(lt::to_svg(plot_of({{"", {1, 2, 3}, {1, 2, 3}, true, true}})), "<circle") == 3);
  const std::string dots = lt::to_svg(plot_of({{"", {1, 2, 3}, {1, 2, 3}, false, true}}));
  CHECK(curves(dots).empty());
}

TEST_CASE("plot: no series and empty series say that there is no data") {
  for (const auto& series : {std::vector<lt::Series>{}, std::vector<lt::Series>{{"empty", {}, {}}}})
    for (const bool is_log : {false, true}) {
      lt::Plot plot = plot_of(series);
      plot.log_x = plot.log_y = is_log;
      const std::string svg = lt::to_svg(plot);
      CHECK(problem(svg).empty());
      CHECK(contains(svg, "no data"));
    }
}

TEST_CASE("plot: larger values are higher up, and everything lies inside") {
  lt::TestRandom random(4);
  for (int round = 0; round < 50; ++round) {
    lt::Plot plot = plot_of({});
    plot.log_x = round % 2 == 1;
    plot.log_y = round % 3 == 1;
    const double scale = std::pow(10, random.uniform(-12, 12));
    for (int s = 0; s < 9; ++s) {
      lt::Series series{"series number " + std::to_string(s), {}, {}, true, s % 2 == 1};
      for (int i = 0; i < 20; ++i) {
        series.x.push_back(i);
        series.y.push_back(random.uniform(-1, 5) * scale);
      }
      plot.series.push_back(series);
    }
    const std::string svg = lt::to_svg(plot);
    REQUIRE(problem(svg).empty());
    for (const std::string& x : all_matches(svg, " c?x=\"([^\"]*)\""))
      REQUIRE((std::stod(x) >= 0 && std::stod(x) <= 720));
    for (const std::string& y : all_matches(svg, " c?y=\"([^\"]*)\""))
      REQUIRE((std::stod(y) >= 0 && std::stod(y) <= 440));
  }
  const auto path = curves(lt::to_svg(plot_of({{"", {0, 1}, {0, 1}}}))).at(0);
  const auto ys = all_matches(path, " ([0-9.]+)");
  REQUIRE(ys.size() == 2);
  CHECK(std::stod(ys[0]) > std::stod(ys[1]));
}

TEST_CASE("plot: long words are broken into lines") {
  const auto lines = lt::wrap("a title of several words that is too long for one line", 200);
  REQUIRE(lines.size() > 1);
  std::string joined;
  for (const std::string& line : lines) {
    CHECK(lt::text_width(line) <= 200);
    joined += (joined.empty() ? "" : " ") + line;
  }
  CHECK(joined == "a title of several words that is too long for one line");
  CHECK(lt::wrap("unbreakable", 5) == std::vector<std::string>{"unbreakable"});
  CHECK(lt::wrap("", 100).empty());
}

TEST_CASE("plot: labels move apart, in order, inside, and no farther than they must") {
  const auto place = [](const std::vector<double>& wanted, double top, double bottom) {
    std::vector<lt::EndLabel> labels;
    for (const double y : wanted)
      labels.push_back({labels.size(), {"label"}, 0, y, y, 0});
    lt::move_apart(labels, top, bottom);
    std::vector<double> ys;
    for (const lt::EndLabel& label : labels)
      ys.push_back(label.y);
    return ys;
  };
  const double h = lt::line_height;
  // Far apart: all stay. Two at one place: half a line each. In a corner: pushed inside.
  CHECK(place({100, 200, 300}, 0, 400) == std::vector<double>{100, 200, 300});
  CHECK(place({200, 200}, 0, 400) == std::vector<double>{200 - h / 2, 200 + h / 2});
  CHECK(place({1, 2}, 0, 400) == std::vector<double>{h / 2, 3 * h / 2});
  CHECK(place({399, 398}, 0, 400) == std::vector<double>{400 - 3 * h / 2, 400 - h / 2});
  lt::TestRandom random(9);
  for (int round = 0; round < 500; ++round) {
    std::vector<double> wanted(1 + random.next_bits() % 14);
    for (double& y : wanted)
      y = random.uniform(30, 370);
    const std::vector<double> ys = place(wanted, 10, 390);
    REQUIRE(ys.front() >= 10 + h / 2 - 1e-9);
    REQUIRE(ys.back() <= 390 - h / 2 + 1e-9);
    for (std::size_t i = 1; i < ys.size(); ++i)
      REQUIRE(ys[i] - ys[i - 1] >= h - 1e-9);
  }
}

TEST_CASE("plot: labels of curves that meet are in the order in which the curves come") {
  const std::string svg = lt::to_svg(plot_of({{"low", {0, 1, 2}, {0, 0, 1}},
                                              {"high", {0, 1, 2}, {1, 1, 1}},
                                              {"middle", {0, 1, 2}, {0.5, 0.5, 1}}}));
  CHECK(svg.find(">high<") < svg.find(">middle<"));
  CHECK(svg.find(">middle<") < svg.find(">low<"));
}

namespace {

using Rgb = std::array<double, 3>;

Rgb linear_rgb(const std::string& hex) {
  Rgb rgb{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double signal = std::stoi(hex.substr(2 * c, 2), nullptr, 16) / 255.0;
    rgb[c] = signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

// The contrast of WCAG 2.
double contrast(const Rgb& a, const Rgb& b) {
  const auto luminance = [](const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
  const double bright = std::max(luminance(a), luminance(b));
  const double dark = std::min(luminance(a), luminance(b));
  return (bright + 0.05) / (dark + 0.05);
}

// CIELAB 1976 for D65.
Rgb lab(const Rgb& c) {
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505);
  const double y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
  const double z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// Dichromats' view of linear color (Machado, Oliveira and Fernandes 2009, severity 1).
using Matrix = std::array<Rgb, 3>;
constexpr Matrix everyone = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix protanope = {{{0.152286, 1.052583, -0.204868},
                               {0.114503, 0.786281, 0.099216},
                               {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix deuteranope = {{{0.367322, 0.860646, -0.227968},
                                 {0.280085, 0.672501, 0.047413},
                                 {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix tritanope = {{{1.255528, -0.076749, -0.178779},
                               {-0.078411, 0.930809, 0.147602},
                               {0.004733, 0.691367, 0.303900}}};

Rgb seen(const Matrix& m, const Rgb& c) {
  Rgb result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = std::clamp(m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2], 0.0, 1.0);
  return result;
}

double difference(const Rgb& a, const Rgb& b) {
  const Rgb p = lab(a);
  const Rgb q = lab(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

TEST_CASE("plot: colors have contrast and stay apart for every kind of color vision") {
  const std::string style = lt::plot_style();
  const std::size_t split = style.find("@media");
  for (const bool is_dark : {false, true}) {
    const std::string css = is_dark ? style.substr(split) : style.substr(0, split);
    const Rgb page = linear_rgb(is_dark ? "0d1117" : "ffffff");
    for (const std::string& hex : all_matches(css, "fill:#([0-9a-f]{6})"))
      CHECK(contrast(linear_rgb(hex), page) >= 4.5);
    const auto hexes = all_matches(css, "\\.c[0-9]\\{stroke:#([0-9a-f]{6})");
    REQUIRE(hexes.size() == 6);
    for (const Matrix& eye : {everyone, protanope, deuteranope, tritanope})
      for (std::size_t i = 0; i < hexes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          INFO(hexes[i] << " and " << hexes[j]);
          // 2.3 is a difference that is just noticed, side by side.
          CHECK(difference(seen(eye, linear_rgb(hexes[i])), seen(eye, linear_rgb(hexes[j]))) > 15);
        }
  }
}
