#include "ch07_fresnel/program.hpp"

#include "ch01_pixels/tests/temporary_folder.hpp"
#include "ch05_rendering_equation/tests/program_checks.hpp"
#include "ch07_fresnel/cost.hpp"
#include "ch07_fresnel/tables.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const std::atomic<bool> never{false};

SmoothViewOptions small(const std::string& view, const std::string& wrong = "none") {
  SmoothViewOptions show;
  show.view = view;
  show.wrong = wrong;
  show.texels = 16;
  return show;
}

double mean_of(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      sum += std::min(image.at(x, y).g, 2.0f);
  return sum / image.width() / image.height();
}

double mean_of(const std::string& view, const std::string& wrong) {
  return mean_of(smooth_picture(small(view, wrong), 24, 18, {.last = 16}, never));
}

}  // namespace

TEST_CASE("program: every mistake has its picture") {
  CHECK(mean_of("glass", "sides") != mean_of("glass", "none"));
  CHECK(mean_of("glass", "twice") < 0.95 * mean_of("glass", "none"));
  CHECK(mean_of("water", "root") < 0.95 * mean_of("water", "none"));
  CHECK(mean_of("water", "scale") < 0.7 * mean_of("water", "none"));
  CHECK(mean_of("metal", "printed") < mean_of("metal", "none"));
}

TEST_CASE("program: without the scale the dry room is the same but for rounding") {
  const Image right = smooth_picture(small("room"), 24, 18, {.last = 8}, never);
  const Image wrong = smooth_picture(small("room", "scale"), 24, 18, {.last = 8}, never);
  CHECK(mean_of(wrong) == Approx(mean_of(right)).epsilon(1e-5));
}

TEST_CASE("program: a strip of any size has its four panels") {
  for (const char* view : {"indices", "metals"})
    for (const ivec2 size : {ivec2{1, 1}, ivec2{7, 5}, ivec2{80, 4}}) {
      const Image image = smooth_strip(small(view), size.x, size.y, {.last = 1}, never);
      CHECK(image.width() == size.x);
      CHECK(image.height() == size.y);
      if (size.x == 80) CHECK(image.at(20, 0) == Rgb(1.0f));  // the line before the second panel
    }
}

TEST_CASE("program: a cancelled room is a whole picture of what there is") {
  const TemporaryFolder folder;
  const std::atomic<bool> already{true};
  RenderOptions picture;
  picture.width = 24;
  picture.height = 18;
  write_smooth_view(small("room"), picture, folder / "room.png", already);
  CHECK(read_pixels8(folder / "room.png").width == 24);
}

TEST_CASE("program: a strip has its panels side by side and two white columns between them") {
  const Rgb colours[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto panel = [&](std::size_t i, int width, Progress&) {
    return Image(width, 2, colours[i]);
  };
  const Image image = panel_strip("strip", 3, 10, 2, 1, panel);
  // Thirds of ten pixels begin at 0, 3 and 6.
  const std::string row = "rrr  g  bb";
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 10; ++x) {
      CAPTURE(x, y);
      const auto kind = std::string("rgb").find(row[static_cast<std::size_t>(x)]);
      CHECK(image.at(x, y) == (kind == std::string::npos ? Rgb(1.0f) : colours[kind]));
    }
}

TEST_CASE("program: plots are drawn into files that end in svg and nowhere else") {
  check_plots(write_curves, {{"polarised", "Brewster 56.3"},
                             {"outside", "67.5"},
                             {"inside", "glass 41.8"},
                             {"gold", "From air to gold"},
                             {"silver", "silver"},
                             {"copper", "copper"},
                             {"schlick", "Schlick minus"},
                             {"printed", "as printed"}});
}

TEST_CASE("program: the table has glass at 60 degrees from both sides") {
  const std::string table = reflectance_table();
  CHECK(table.find("0.0892") != std::string::npos);
  CHECK(table.find("1.0000 1.0000") != std::string::npos);
}

TEST_CASE("program: every row of the table of costs is a time") {
  const std::string table = cost_table(1);
  CHECK(std::count(table.begin(), table.end(), '\n') == 8);
  CHECK(table.find("nan") == std::string::npos);
  CHECK(table.find("inf") == std::string::npos);
}
