#include "common/plot.hpp"

#include <cmath>
#include <limits>

#include "common/error.hpp"
#include "common/plot/end_labels.hpp"
#include "common/plot/text.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/exercise.hpp"
#include "common/tests/svg_text.hpp"
#include "common/tests/temporary_folder.hpp"
#include "common/tests/xml.hpp"

using namespace lt::test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

lt::Plot plot_of(const std::vector<lt::Series>& series) {
  return {"Title", "x", "y", false, false, "What to see.", series};
}

std::vector<std::string> curves(const std::string& svg) {
  return all_between(svg, "class=\"curve\" d=\"", "\"");
}

std::size_t count(const std::string& text, const std::string& part) {
  return all_between(text, part, "").size();
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
  const std::string svg = lt::to_svg(plot);
  const auto rules = all_between(svg, "font-size:", "px");
  const auto attributes = all_between(svg, "font-size=\"", "\"");
  REQUIRE(rules.size() == 1);
  REQUIRE_FALSE(attributes.empty());
  CHECK(std::stod(rules[0]) >= 15);
  for (const std::string& size : attributes)
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

TEST_CASE("plot: a series may wear another's color") {
  lt::Plot plot = plot_of({{"one", {0, 1}, {0, 1}}, {"two", {0, 1}, {1, 0}}});
  CHECK(contains(lt::to_svg(plot), "<g class=\"c1\">"));
  plot.series[1].color_of = 0;
  CHECK_FALSE(contains(lt::to_svg(plot), "<g class=\"c1\">"));
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

TEST_CASE("plot: everything lies inside the picture") {
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
    for (const std::string name : {" x=\"", " cx=\""})
      for (const std::string& x : all_between(svg, name, "\""))
        REQUIRE((std::stod(x) >= 0 && std::stod(x) <= 720));
    for (const std::string name : {" y=\"", " cy=\""})
      for (const std::string& y : all_between(svg, name, "\""))
        REQUIRE((std::stod(y) >= 0 && std::stod(y) <= 440));
  }
}

TEST_CASE("plot: larger values are further right and higher up") {
  const std::string svg = lt::to_svg(plot_of({{"", {0, 1}, {0, 1}, true, true}}));
  const auto xs = all_between(svg, " cx=\"", "\"");
  const auto ys = all_between(svg, " cy=\"", "\"");
  REQUIRE(xs.size() == 2);
  CHECK(std::stod(xs[0]) < std::stod(xs[1]));
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

TEST_CASE("plot: dots and their line have the same x and one color, whatever was drawn before") {
  lt::Plot plot = plot_of({{"first", {1, 2}, {1, 2}}});
  lt::Series measured;
  measured.add(2, 5);
  measured.add(3, 7);
  lt::add_dots_and_line(plot, measured, "law", [](double x) { return x * x; });
  REQUIRE(plot.series.size() == 3);
  const lt::Series& dots = plot.series[1];
  const lt::Series& line = plot.series[2];
  CHECK((dots.show_points && !dots.show_line && dots.label.empty()));
  CHECK((line.show_line && !line.show_points && line.label == "law"));
  CHECK(dots.y == std::vector<double>{5, 7});
  CHECK(line.x == std::vector<double>{2, 3});
  CHECK(line.y == std::vector<double>{4, 9});
  CHECK(line.color_of == 1);
  CHECK(dots.color_of < 0);  // its own
}

TEST_CASE("plot path: a name that does not end in .svg is refused with the remedy") {
  CHECK_NOTHROW(lt::require_plot_path("out/plot.svg"));
  for (const char* name : {"plot.png", "plot", "plot.SVG", "svg", ".svg"}) {
    INFO(name);
    CHECK_THROWS_AS(lt::require_plot_path(name), lt::InputError);
  }
  CHECK(input_error([] { lt::require_plot_path("plot.png"); }) ==
        "--out: plot.png is no plot; end it in .svg");
}
