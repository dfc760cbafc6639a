#include "ch11_refraction/program.hpp"

#include "ch01_pixels/tests/temporary_folder.hpp"
#include "ch05_rendering_equation/tests/program_checks.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const std::atomic<bool> never{false};

GlassViewOptions small(const std::string& view, const std::string& wrong = "none") {
  GlassViewOptions show;
  show.view = view;
  show.wrong = wrong;
  show.texels = 16;
  return show;
}

Film film_of(const GlassViewOptions& show, ivec2 size, int spp, int threads = 0) {
  Film film(size.x, size.y);
  with_view(show, [&](const Camera& camera, const AnyEstimator& estimate) {
    render(film, camera, estimate, {.last = spp, .threads = threads, .tile_size = 8}, never);
  });
  return film;
}

glm::dvec3 mean_of(const Film& film) {
  const Image image = developed(film);
  glm::dvec3 sum(0.0);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      sum += glm::dvec3(min(image.at(x, y), Rgb(2.0f)));
  return sum / double(image.width() * image.height());
}

double mean_green(const std::string& view, const std::string& wrong = "none") {
  return mean_of(film_of(small(view, wrong), {84, 24}, 32)).g;
}

}  // namespace

TEST_CASE("program: no view has a sample that is negative or infinite or NaN") {
  for (const char* view : {"room", "caustic", "sphere", "spheres", "furnace", "lamp"})
    CHECK(summary(film_of(small(view), {30, 24}, 16)).bad == 0);
  for (const char* wrong : {"printed", "twice", "root", "weight", "scale", "sides", "glow"})
    CHECK(summary(film_of(small("furnace", wrong), {56, 12}, 16)).bad == 0);
}

TEST_CASE("program: no ball of the furnace is brighter than its sky, and rough ones are darker") {
  const Image image = developed(film_of(small("furnace"), {84, 14}, 64));
  // Each weight is at most 1 on a path that begins and ends in air, and the sky is 1/2.
  for (int x = 0; x < 84; ++x)
    REQUIRE(image.at(x, 7).g <= 0.5f + 1e-4f);
  CHECK(image.at(6, 7).g == close_to(0.5, 0.02));  // alpha 0.02
  CHECK(image.at(77, 7).g < 0.35f);                // alpha 1
}

TEST_CASE("program: every mistake has its picture") {
  const double right = mean_green("furnace");
  CHECK(mean_green("furnace", "weight") > 1.02 * right);
  CHECK(mean_green("furnace", "glow") > 1.1 * right);
  CHECK(mean_green("furnace", "sides") < 0.9 * right);
  CHECK(mean_green("furnace", "twice") < 0.8 * right);
  CHECK(mean_green("furnace", "printed") < 0.8 * right);
  CHECK(mean_green("sphere", "root") != mean_green("sphere"));
  CHECK(mean_green("lamp", "scale") > 1.2 * mean_green("lamp"));
}

TEST_CASE("program: the room's clear sphere is pink, and clear if its colour is taken away") {
  GlassViewOptions show = small("sphere");
  show.ior = 1.04f;
  const auto ratio = [&](float colour) {
    show.colour = colour;
    const glm::dvec3 mean = mean_of(film_of(show, {24, 24}, 64));
    return mean.r / mean.g;
  };
  CHECK(ratio(1.0f) > 1.3 * ratio(0.0f));
  CHECK(ratio(4.0f) > 1.2 * ratio(1.0f));
}

TEST_CASE("program: a view has its own index unless one asks for another") {
  CHECK(index_of(small("room")) == 1.04f);
  CHECK(index_of(small("caustic")) == 1.5f);
  GlassViewOptions show = small("room");
  show.ior = 1.33f;
  CHECK(index_of(show) == 1.33f);
}

TEST_CASE("program: strips change one thing, and one of any size has its four panels") {
  CHECK(panels_of(small("alphas"))[3].roughness == 0.5f);
  CHECK(panels_of(small("indices"))[0].ior == 1.04f);
  CHECK(panels_of(small("colours"))[2].colour == 4.0f);
  for (const ivec2 size : {ivec2{1, 1}, ivec2{7, 5}, ivec2{80, 4}}) {
    const Image image = glass_strip(small("alphas"), size.x, size.y, {.last = 1}, never);
    CHECK(image.width() == size.x);
    CHECK(image.height() == size.y);
    if (size.x == 80) CHECK(image.at(20, 0) == Rgb(1.0f));  // the line before the second panel
  }
}

TEST_CASE("program: the picture is the same for any number of threads") {
  const Film one = film_of(small("room"), {33, 21}, 2, 1);
  const Film seven = film_of(small("room"), {33, 21}, 2, 7);
  require_same_samples(one, seven);
}

TEST_CASE("program: a cancelled view is a whole picture of what there is") {
  const TemporaryFolder folder;
  const std::atomic<bool> already{true};
  RenderOptions picture;
  picture.width = 24;
  picture.height = 18;
  for (const char* view : {"room", "alphas"}) {
    write_glass_view(small(view), picture, folder / "view.png", already);
    CHECK(read_pixels8(folder / "view.png").width == 24);
  }
}

TEST_CASE("program: plots are drawn into files that end in svg and nowhere else") {
  check_plots(write_glass_plot, {{"through", "BTDF"},
                                 {"root", "as printed"},
                                 {"energy", "let through"},
                                 {"weight", "equation 17"},
                                 {"beer", "metres"}});
}

TEST_CASE("program: the tables have both sides, all mistakes, and the room's speed") {
  const std::string energy = energy_both_ways_table(30);
  CHECK(std::count(energy.begin(), energy.end(), '\n') == 20);
  const std::string furnace = glass_furnace_table(200, 1);
  CHECK(std::count(furnace.begin(), furnace.end(), '\n') == 9);
  const std::string cost = glass_cost_table(1);
  CHECK(std::count(cost.begin(), cost.end(), '\n') == 8);
  CHECK(cost.find("million/s") != std::string::npos);
  for (const std::string& table : {energy, furnace, cost})
    CHECK(table.find("nan") == std::string::npos);
}
