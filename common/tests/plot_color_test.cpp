#include <algorithm>
#include <array>
#include <cmath>

#include "common/plot/style.hpp"
#include "common/testkit/catch.hpp"
#include "common/tests/svg_text.hpp"

using namespace lt::test;

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
    for (const std::string& hex : all_between(css, "fill:#", "}"))
      CHECK(contrast(linear_rgb(hex), page) >= 4.5);
    std::vector<std::string> hexes;
    for (std::size_t i = 0; i < 6; ++i)
      hexes.push_back(all_between(css, "." + lt::curve_class(i) + "{stroke:#", "}").at(0));
    CHECK(lt::curve_class(6) == lt::curve_class(0));
    for (const Matrix& eye : {everyone, protanope, deuteranope, tritanope})
      for (std::size_t i = 0; i < hexes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          INFO(hexes[i] << " and " << hexes[j]);
          // 2.3 is a difference that is just noticed, side by side.
          CHECK(difference(seen(eye, linear_rgb(hexes[i])), seen(eye, linear_rgb(hexes[j]))) > 15);
        }
  }
}
