#include "ch01_pixels/tests/temporary_folder.hpp"
#include "ch05_rendering_equation/tests/program_checks.hpp"
#include "ch08_microfacets/microfacet_tables.hpp"
#include "ch08_microfacets/microfacet_views.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const std::atomic<bool> never{false};

Image picture_of(const std::string& view, const BrdfOptions& brdf,
                 const std::string& material = "gold") {
  MicrofacetViewOptions show;
  show.view = view;
  show.brdf = brdf;
  show.material = material;
  Film film(140, 22);
  render(film, row_camera(), row_estimator(show), {.last = 16}, never);
  require_good_samples(film);
  return developed(film);
}

/// Mean of a ball's pixels, 0 to 6 from the left; each at most 1, as a file would have it.
double mean_of_ball(const Image& image, int ball) {
  double sum = 0;
  for (int y = 0; y < 22; ++y)
    for (int x = 20 * ball; x < 20 * ball + 20; ++x)
      sum += std::min(1.0f, image.at(x, y).g);
  return sum / 440;
}

}  // namespace

TEST_CASE("program: the rougher a ball is, the more of it the lamp lights up, but for the last") {
  // At alpha 1 two thirds of the light are lost.
  const Image image = picture_of("spheres", {});
  for (int ball = 1; ball < row_count - 1; ++ball)
    CHECK(mean_of_ball(image, ball) > mean_of_ball(image, ball - 1));
  CHECK(mean_of_ball(image, 6) < mean_of_ball(image, 5));
}

TEST_CASE("program: under an even sky the rougher ball is darker, never brighter than the sky") {
  const Image image = picture_of("furnace", {});
  for (int ball = 1; ball < row_count; ++ball)
    CHECK(mean_of_ball(image, ball) < mean_of_ball(image, ball - 1));
  for (int x = 0; x < 140; ++x)
    CHECK(image.at(x, 11).g <= 0.5f + 1e-3f);
  CHECK(image.at(130, 11).g == close_to(0.5 * (1 - std::log(2.0)), 2e-3));
}

TEST_CASE("program: the separable form is darker, at rims above all") {
  const Image correlated = picture_of("furnace", {});
  const Image separable = picture_of("furnace", {"separable", "none"});
  CHECK(mean_of_ball(separable, 6) < 0.98 * mean_of_ball(correlated, 6));
  CHECK(separable.at(130, 11).g == close_to(double{correlated.at(130, 11).g}, 2e-3));
}

TEST_CASE("program: every mistake has its picture") {
  const Image right = picture_of("spheres", {});
  const auto spheres = [&](const std::string& wrong) {
    return picture_of("spheres", {"correlated", wrong});
  };
  CHECK(mean_of_ball(spheres("squared"), 3) < 0.7 * mean_of_ball(right, 3));
  CHECK(mean_of_ball(spheres("four"), 6) > 1.2 * mean_of_ball(right, 6));
  CHECK(mean_of_ball(spheres("masking"), 6) > 1.1 * mean_of_ball(right, 6));
  CHECK(mean_of_ball(spheres("half"), 6) < 0.5 * mean_of_ball(right, 6));
  CHECK(mean_of_ball(picture_of("furnace", {"correlated", "half"}), 6) < 0.3);
}

TEST_CASE("program: as printed the highlight faces the lamp instead of mirroring it") {
  // The normal that mirrors a lamp at 45 degrees leans by 22.5, the one that faces it by 45: at
  // sin(22.5) = 0.38 and sin(45) = 0.71 of the radius above the middle, 10 pixels.
  const auto brightest_row = [](const Image& image) {
    int best = 0;
    for (int y = 0; y < 11; ++y)
      if (image.at(50, y).g > image.at(50, best).g) best = y;
    return best;
  };
  CHECK(std::abs(brightest_row(picture_of("spheres", {})) - 7) <= 1);
  CHECK(std::abs(brightest_row(picture_of("spheres", {"separable", "printed"})) - 4) <= 1);
}

TEST_CASE("program: balls of glass are darker than gold, and white ones brighter") {
  const double golden = mean_of_ball(picture_of("spheres", {}), 6);
  CHECK(mean_of_ball(picture_of("spheres", {}, "glass"), 6) < 0.3 * golden);
  CHECK(mean_of_ball(picture_of("spheres", {}, "white"), 6) > golden);
}

TEST_CASE("program: a picture of which no size is asked gets that of its view") {
  // Seven balls of 2.2 m each and a margin: 7 to 1.1. The room is 5 to 4, as in chapter 7.
  const auto size_of = [](const std::string& view, int width, int height) {
    RenderOptions picture;
    picture.width = width;
    picture.height = height;
    choose_size(view, picture);
    return std::pair(picture.width, picture.height);
  };
  CHECK(size_of("spheres", 0, 0) == std::pair(700, 110));
  CHECK(size_of("furnace", 0, 0) == std::pair(700, 110));
  CHECK(size_of("room", 0, 0) == std::pair(450, 360));
  CHECK(size_of("room", 160, 128) == std::pair(160, 128));
  CHECK(size_of("room", 160, 0) == std::pair(160, 360));
}

TEST_CASE("program: a cancelled view is a whole picture of what there is") {
  const TemporaryFolder folder;
  const std::atomic<bool> already{true};
  RenderOptions picture;
  picture.width = 24;
  picture.height = 18;
  for (const char* view : {"spheres", "room"}) {
    MicrofacetViewOptions show;
    show.view = view;
    show.texels = 16;
    write_microfacet_view(show, picture, folder / "view.png", already);
    CHECK(read_pixels8(folder / "view.png").width == 24);
  }
}

TEST_CASE("program: plots are drawn into files that end in svg and nowhere else") {
  check_plots([](const std::string& name,
                 const std::filesystem::path& out) { write_microfacet_plot(name, {}, out); },
              {{"lobes-0", "from 0\u00b0"},
               {"lobes-45", "from 45\u00b0"},
               {"lobes-75", "max\u00a029"},
               {"d", "How facets lean"},
               {"g1", "G1 for five"},
               {"g2", "separable 1.0"},
               {"energy", "give back"},
               {"printed", "as printed, \u03b1 0.3"}});
}

TEST_CASE("program: a furnace as printed is refused, for it would be drawn wrong") {
  const TemporaryFolder folder;
  MicrofacetViewOptions show;
  show.view = "furnace";
  show.brdf.wrong = "printed";
  CHECK_THROWS_AS(write_microfacet_view(show, {}, folder / "x.png", never), InputError);
}

TEST_CASE("program: lobes seen from above are as high as D / 4 says") {
  // 1 / (4 pi alpha^2): 7.96, 1.99, 0.50, 0.16 and 0.08.
  const PolarPlot plot = lobe_plot({}, 0);
  const char* heights[] = {"8.0", "2.0", "0.50", "0.16", "0.08"};
  REQUIRE(plot.curves.size() == 5);
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(plot.curves[i].label.ends_with(heights[i]));
}

TEST_CASE("program: the table of albedos has the closed form and the published ones") {
  // 1 - ln 2 = 0.3069; 0.9883, 0.8774 and 0.5915: errata of thesis eq. 5.
  const std::string table = energy_table({}, 300);
  CHECK(table.find("0.9883  0.8774  0.5915  0.3069") != std::string::npos);
}

TEST_CASE("program: every row of the table of costs is a time") {
  const std::string table = microfacet_cost_table(1);
  CHECK(std::count(table.begin(), table.end(), '\n') == 9);
  CHECK(table.find("nan") == std::string::npos);
  CHECK(table.find("inf") == std::string::npos);
}
