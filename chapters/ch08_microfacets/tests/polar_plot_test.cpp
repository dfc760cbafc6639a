#include "ch08_microfacets/polar_plot.hpp"

#include <algorithm>

#include "ch05_rendering_equation/uniform_lambert.hpp"
#include "ch08_microfacets/lobe_plots.hpp"
#include "ch08_microfacets/tests/oracles.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"
#include "common/tests/xml.hpp"

using namespace lt;
using namespace lt::testing;

TEST_CASE("polar plot: left is left, up is up, and radius 1 is the outer circle") {
  // The middle is at (290, 388), the radius 260.
  const std::string svg = to_svg(PolarPlot{"t", "d", "n", 45, {{"x", {-90, 0, 90}, {1, 1, 0.5}}}});
  CHECK(svg.find("M30 388L290 128L420 388") != std::string::npos);
  CHECK(svg.find(">wo<") != std::string::npos);
}

TEST_CASE("polar plot: it is well-formed, with a title and a description, and escapes its words") {
  const std::string svg = to_svg(PolarPlot{"a < b", "c & d", "n", 0, {{"\u03b1 <", {0}, {1}}}});
  CHECK(test::XmlCheck(svg).problem().empty());
  CHECK(svg.find("<title>a &lt; b</title>") != std::string::npos);
  CHECK(svg.find("<desc>c &amp; d</desc>") != std::string::npos);
}

TEST_CASE("lobes: the longest ray is 1, at the mirror angle for a narrow lobe") {
  const AnyBrdf brdf = brdf_named({}, Ggx{0.02f}, PerfectMirror{});
  const PolarCurve curve = lobe(brdf, 0.02f, 45);
  const auto longest = std::max_element(curve.radii.begin(), curve.radii.end());
  CHECK(*longest == 1.0);
  CHECK(curve.angles[static_cast<std::size_t>(longest - curve.radii.begin())] ==
        close_to(45.0, 0.5));
}

TEST_CASE("lobes: a matt surface's is a circle through the point") {
  // f cos = cos / pi: in polar coordinates r = cos(angle).
  const AnyBrdf matt{[](vec3 wo, vec3 wi) { return lambert(Rgb(1.0f), wo, wi); }};
  const PolarCurve curve = lobe(matt, 1.0f, 30);
  for (std::size_t i = 0; i < curve.angles.size(); ++i)
    REQUIRE(curve.radii[i] == close_to(std::cos(curve.angles[i] * pi_ / 180), 1e-6));
}
