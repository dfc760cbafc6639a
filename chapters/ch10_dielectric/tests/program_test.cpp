#include "ch10_dielectric/program.hpp"

#include "ch01_pixels/tests/temporary_folder.hpp"
#include "ch05_rendering_equation/tests/program_checks.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const std::atomic<bool> never{false};

DielectricViewOptions small(const std::string& view, const std::string& base = "reciprocal",
                            const std::string& wrong = "none") {
  DielectricViewOptions show;
  show.view = view;
  show.base = base;
  show.wrong = wrong;
  show.texels = 16;
  return show;
}

Film film_of(const DielectricViewOptions& show, ivec2 size, int spp, int threads = 0) {
  Film film(size.x, size.y);
  with_view(show, [&](const Camera& camera, const AnyEstimator& estimate) {
    render(film, camera, estimate, {.last = spp, .threads = threads, .tile_size = 8}, never);
  });
  return film;
}

double mean_green(const Film& film) {
  const Image image = developed(film);
  double sum = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      sum += image.at(x, y).g;
  return sum / image.width() / image.height();
}

double furnace_mean(const std::string& base, const std::string& wrong = "none") {
  return mean_green(film_of(small("furnace", base, wrong), {140, 24}, 32));
}

}  // namespace

TEST_CASE("program: no sample is negative or infinite or NaN in any view") {
  for (const char* view : {"room", "spheres", "furnace"})
    for (const char* base : {"thesis", "reciprocal", "conserving"})
      CHECK(summary(film_of(small(view, base), {30, 24}, 16)).bad == 0);
}

TEST_CASE("program: in the furnace conserving balls vanish, reciprocal ones are darker") {
  CHECK(furnace_mean("conserving") == close_to(0.5, 1e-3));
  CHECK(furnace_mean("reciprocal") < 0.49);
}

TEST_CASE("program: every mistake has its picture") {
  CHECK(furnace_mean("reciprocal", "base") > 0.502);
  CHECK(furnace_mean("reciprocal", "divide") < 0.98 * furnace_mean("reciprocal"));
  CHECK(furnace_mean("reciprocal", "density") != furnace_mean("reciprocal"));
}

TEST_CASE("program: the thesis' smoothest ball is brighter than the sky at its rim") {
  const Studio studio = coated_row("furnace");
  const auto estimate = estimator_in(studio, small("furnace", "thesis"));
  const auto seen_at = [&](float b) {  // metres to the left of the leftmost ball's axis
    double sum = 0;
    for (int i = 0; i < 4'000; ++i) {
      Pcg32 random = stream_for(1, 0, 0, i);
      sum += estimate({{-6.6f - b, 0.0f, -60.0f}, {0.0f, 0.0f, 1.0f}}, random).g;
    }
    return sum / 4'000;
  };
  CHECK(seen_at(0.0f) < 0.5);
  CHECK(seen_at(0.98f) > 0.55);  // cosine 0.2: 1.2 times the sky
}

TEST_CASE("program: the floor is as rough as one asks, and a strip of any size has its four") {
  CHECK(coated_room(16, 0.25f).looks[room::floor].material.roughness == 0.25f);
  for (const ivec2 size : {ivec2{1, 1}, ivec2{7, 5}, ivec2{80, 4}}) {
    const Image image = floors_strip(small("floors"), size.x, size.y, {.last = 1}, never);
    CHECK(image.width() == size.x);
    CHECK(image.height() == size.y);
    if (size.x == 80) CHECK(image.at(20, 0) == Rgb(1.0f));  // the line before the second panel
  }
}

TEST_CASE("program: the picture is the same for any number of threads") {
  const Film one = film_of(small("room", "conserving"), {33, 21}, 2, 1);
  const Film seven = film_of(small("room", "conserving"), {33, 21}, 2, 7);
  require_same_samples(one, seven);
}

TEST_CASE("program: a cancelled room is a whole picture of what there is") {
  const TemporaryFolder folder;
  const std::atomic<bool> already{true};
  RenderOptions picture;
  picture.width = 24;
  picture.height = 18;
  write_dielectric_view(small("room"), picture, folder / "room.png", already);
  CHECK(read_pixels8(folder / "room.png").width == 24);
}

TEST_CASE("program: plots are drawn into files that end in svg and nowhere else") {
  check_plots(write_coat_plot, {{"coat", "reflects: E"},
                                {"printed", "Thesis equation 7"},
                                {"repairs", "conserving"},
                                {"choice", "probability of choosing"}});
}

TEST_CASE("program: the tables have the thesis' gain, all choices, and times") {
  CHECK(totals_table("thesis", 100).find("1.44") != std::string::npos);
  const std::string choices = choice_table(50);
  CHECK(std::count(choices.begin(), choices.end(), '\n') == 17);
  const std::string times = coat_cost_table(1);
  CHECK(std::count(times.begin(), times.end(), '\n') == 7);
  CHECK(times.find("nan") == std::string::npos);
}
