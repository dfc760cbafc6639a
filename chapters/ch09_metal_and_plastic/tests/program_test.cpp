#include "ch09_metal_and_plastic/program.hpp"

#include "ch01_pixels/tests/temporary_folder.hpp"
#include "ch05_rendering_equation/tests/program_checks.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const std::atomic<bool> never{false};

RoughViewOptions small(const std::string& view, const std::string& wrong = "none") {
  RoughViewOptions show;
  show.view = view;
  show.wrong = wrong;
  show.texels = 16;
  return show;
}

Film film_of(const RoughViewOptions& show, int spp, int threads = 0) {
  Film film(42, 20);
  render(film, rough_camera(show), rough_estimator(show),
         {.last = spp, .threads = threads, .tile_size = 8}, never);
  return film;
}

double mean_of_green(const RoughViewOptions& show) {
  const Image image = developed(film_of(show, 16));
  double sum = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      sum += std::min(image.at(x, y).g, 2.0f);
  return sum / image.width() / image.height();
}

}  // namespace

TEST_CASE("program: no view has a sample that is negative, infinite or NaN") {
  for (const char* view : {"room", "gold", "green", "spheres", "furnace", "floor"})
    for (const char* normals : {"visible", "all"}) {
      RoughViewOptions show = small(view);
      show.normals = normals;
      CHECK(summary(film_of(show, 16)).bad == 0);
    }
}

TEST_CASE("program: every mistake has its picture, and no sample of it is bad") {
  const double right = mean_of_green(small("spheres"));
  CHECK(mean_of_green(small("spheres", "jacobian")) < 0.95 * right);
  CHECK(mean_of_green(small("spheres", "cosine")) < right);
  CHECK(mean_of_green(small("spheres", "twice")) > 1.05 * right);
  CHECK(mean_of_green(small("spheres", "angles")) < 0.95 * right);
  CHECK(mean_of_green(small("spheres", "fresnel")) != right);
  const double lost = mean_of_green(small("furnace"));
  CHECK(mean_of_green(small("furnace", "redraw")) > 1.02 * lost);
  CHECK(mean_of_green(small("furnace", "absolute")) > lost);
  for (const char* wrong : {"jacobian", "cosine", "redraw", "twice", "fresnel", "angles"})
    CHECK(summary(film_of(small("room", wrong), 8)).bad == 0);
}

TEST_CASE("program: a furnace of white metal is never brighter than its sky") {
  // Visible normals: each weight is at most 1, and the sky is 1/2.
  const Image image = developed(film_of(small("furnace"), 16));
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      REQUIRE(image.at(x, y).g <= 0.5f + 1e-5f);
}

TEST_CASE("program: the picture is the same for any number of threads") {
  for (const char* view : {"room", "floor"}) {
    const Film one = film_of(small(view), 2, 1), seven = film_of(small(view), 2, 7);
    require_same_samples(one, seven);
  }
}

TEST_CASE("program: a pair of any size has two halves and a line between them") {
  for (const ivec2 size : {ivec2{1, 1}, ivec2{2, 3}, ivec2{3, 1}, ivec2{40, 4}}) {
    const Image image = normals_pair(small("pair"), size.x, size.y, {.last = 1}, never);
    CHECK(image.width() == size.x);
    CHECK(image.height() == size.y);
    if (size.x == 40) CHECK(image.at(20, 0) == Rgb(1.0f));
  }
}

TEST_CASE("program: a cancelled view is a whole picture of what there is") {
  const TemporaryFolder folder;
  const std::atomic<bool> already{true};
  RenderOptions picture;
  picture.width = 24;
  picture.height = 18;
  for (const char* view : {"room", "pair"}) {
    write_rough_view(small(view), picture, folder / "view.png", already);
    CHECK(read_pixels8(folder / "view.png").width == 24);
  }
}

TEST_CASE("program: plots are drawn into files that end in svg and nowhere else") {
  check_plots([](const std::string& name,
                 const std::filesystem::path& out) { write_sampler_plot(name, 1, out); },
              {{"weights", "largest"},
               {"facets", "visible"},
               {"noise", "deviation"},
               {"chi-square", "redrawn"}});
}

TEST_CASE("program: every row of the tables is of numbers") {
  RenderOptions picture;
  picture.samples_per_pixel = 2;
  const std::string tables[] = {weight_table(1000, 1), rough_cost_table(1),
                                rough_efficiency_table(small("room"), 2, 1)};
  const int rows[] = {7, 12, 13};
  for (int i = 0; i < 3; ++i) {
    CHECK(std::count(tables[i].begin(), tables[i].end(), '\n') == rows[i]);
    CHECK(tables[i].find("nan") == std::string::npos);
    CHECK(tables[i].find("inf ") == std::string::npos);
  }
}
