#include "ch06_importance_sampling/program.hpp"

#include "ch01_pixels/tests/temporary_folder.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const std::atomic<bool> never{false};

SamplingOptions options_for(const std::string& view, const std::string& wrong = "none") {
  SamplingOptions show;
  show.view = view;
  show.room.wrong = wrong;
  show.directions = 500;
  show.texels = 16;
  return show;
}

RenderOptions picture_of(int width, int height, int spp = 2) {
  RenderOptions picture;
  picture.width = width;
  picture.height = height;
  picture.samples_per_pixel = spp;
  return picture;
}

}  // namespace

TEST_CASE("program: every view is a picture of any size") {
  for (const char* view : {"pair", "gain", "directions", "bins"})
    for (const ivec2 size : {ivec2{1, 1}, ivec2{2, 3}, ivec2{37, 5}, ivec2{64, 48}}) {
      const Image image = make_picture(options_for(view), picture_of(size.x, size.y), never);
      CAPTURE(view, size.x, size.y);
      CHECK(image.width() == size.x);
      CHECK(image.height() == size.y);
    }
}

TEST_CASE("program: both samplers write the room, in both layouts the same bytes") {
  const TemporaryFolder folder;
  for (const char* view : {"uniform", "cosine"}) {
    SamplingOptions show = options_for(view);
    write_view(show, picture_of(24, 18), folder / "packed.png", never);
    show.room.layout = "list";
    write_view(show, picture_of(24, 18), folder / "list.png", never);
    CHECK(read_file(folder / "packed.png") == read_file(folder / "list.png"));
  }
}

TEST_CASE("program: every mistake has its room and its directions") {
  const SampledRoom room(16);
  const auto mean = [&](const std::string& sampler, const std::string& wrong) {
    Film film(24, 18);
    render(film, room_camera_far(), estimator_for(room, {sampler, wrong, "packed", 8}),
           {.last = 16}, never);
    return mean_of(developed(film));
  };
  const double right = mean("cosine", "none");
  CHECK(mean("cosine", "density") > 1.05 * right);
  CHECK(mean("cosine", "root") != right);
  CHECK(mean("cosine", "both") == right);
  CHECK(mean("uniform", "both") != right);

  const Image fine = directions_picture(60, 30, "none", 200, 1);
  for (const char* wrong : {"density", "root", "both"}) {
    const Image image = directions_picture(60, 30, wrong, 200, 1);
    CHECK(mean_of(image) != mean_of(fine));
  }
}

TEST_CASE("program: the map of the gain is orange where the cosine's noise is less") {
  const Rgb better = gain_color(3.0);
  const Rgb worse = gain_color(1 / 3.0);
  CHECK(better.r > better.b);
  CHECK(worse.b > worse.r);
  CHECK(gain_color(1.0).r == gain_color(1.0).b);
  CHECK(gain_color(0.0) == Rgb(0.0f));
  Image four(1, 1, Rgb(4.0f)), one(1, 1, Rgb(1.0f));
  CHECK(gain_at(four, one, 0, 0) == Approx(4));
  CHECK(gain_at(four, Image(1, 1), 0, 0) == 0);
}

TEST_CASE("program: pulls are in standard deviations and nothing expected is nothing wrong") {
  CHECK(pull(120, 100) == Approx(2));
  CHECK(pull(70, 100) == Approx(-3));
  CHECK(pull(0, 0) == 0);
  CHECK(pull_color(pull(1, 0)) == pull_color(5));
  CHECK(pull_color(0) == Rgb(0.18f));
  CHECK(pull_color(-9).b > pull_color(-9).r);
}

TEST_CASE("program: dots near the edge of a picture stay inside it") {
  Image image(4, 3);
  for (const vec2 at : {vec2(-9.0f), vec2(-0.5f, 1.0f), vec2(4.2f, 2.9f), vec2(99.0f, 1.0f)})
    add_dot(image, at, Rgb(1.0f));
  add_dot(image, {2.5f, 1.5f}, Rgb(1.0f));
  CHECK(image.at(2, 1) == Rgb(1.0f));
}

TEST_CASE("program: plots are drawn into files that end in svg and nowhere else") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(write_plot("heights", options_for("cosine"), {}, folder / "plot.png", never),
                  InputError);
  write_plot("heights", options_for("cosine"), {}, folder / "plot.svg", never);
  CHECK(read_file(folder / "plot.svg").find("cosine: 2z") != std::string::npos);
}

TEST_CASE("program: chi-square stays near one where it is right and grows where it is wrong") {
  const Plot plot = chi_square_plot(1);
  REQUIRE(plot.series.size() == 4);
  for (const std::size_t right : {0u, 1u})
    for (const double ratio : plot.series[right].y) {
      CHECK(ratio > 0.3);  // 6 sigma of 31 degrees of freedom and more
      CHECK(ratio < 2.6);
    }
  for (const std::size_t wrong : {2u, 3u})
    CHECK(plot.series[wrong].y.back() > 300 * plot.series[wrong].y.front());
}

TEST_CASE("program: the table names both samplers for every camera") {
  const std::string table = efficiency_table(options_for("cosine"), 2, 1);
  for (const char* word : {"far", "near", "close", "uniform", "cosine"})
    CHECK(table.find(word) != std::string::npos);
}
