#include "ch05_rendering_equation/program.hpp"

#include "ch01_pixels/tests/temporary_folder.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const std::atomic<bool> never{false};

RenderOptions small_picture(int samples) {
  RenderOptions picture;
  picture.width = 24;
  picture.height = 18;
  picture.samples_per_pixel = samples;
  return picture;
}

LitViewOptions with_mistake(const std::string& wrong) {
  LitViewOptions show;
  show.wrong = wrong;
  show.texels = 16;
  return show;
}

// Of the lower half, without the lamp.
double mean_of(const Image& image) {
  double sum = 0;
  for (int y = image.height() / 2; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      sum += image.at(x, y).g;
  return sum / image.width() / (image.height() / 2);
}

}  // namespace

TEST_CASE("program: a picture in one go has all of its samples") {
  RenderOptions picture = small_picture(5);
  picture.seed = 7;
  picture.threads = 2;
  const SampleRange range = whole_range_for(picture);
  CHECK(range.last == 5);
  CHECK(range.seed == 7);
  CHECK(range.threads == 2);
}

TEST_CASE("program: a cancelled room is a whole picture of what there is") {
  const TemporaryFolder folder;
  const std::atomic<bool> already{true};
  write_room(with_mistake("none"), small_picture(4), folder / "room.png", already);
  CHECK(read_pixels8(folder / "room.png").width == 24);
}

TEST_CASE("program: every mistake has its picture") {
  const TexturedScene scene = matt_room(16);
  const auto mean = [&](const std::string& wrong, int depth) {
    Film film(24, 18);
    render(film, room_camera_far(), estimator_for(wrong, scene, depth), {.last = 16}, never);
    return mean_of(developed(film));
  };
  const double right = mean("none", 8);
  CHECK(mean("cosine", 8) > 1.5 * right);
  CHECK(mean("pi", 8) > 2 * right);
  CHECK(mean("offset", 8) != right);
  CHECK(mean("depth", 1) == 0);
}

TEST_CASE("program: a strip of any size has its six panels") {
  const TexturedScene scene = matt_room(16);
  for (const ivec2 size : {ivec2{1, 1}, ivec2{7, 5}, ivec2{50, 4}}) {
    const Image image = strip(estimator_for("none", scene, 1), size.x, size.y, {}, never);
    CHECK(image.width() == size.x);
    CHECK(image.height() == size.y);
    if (size.x == 50) CHECK(image.at(8, 0) == Rgb(1.0f));  // the line before the second panel
  }
}

TEST_CASE("program: plots are drawn into files that end in svg and nowhere else") {
  const TemporaryFolder folder;
  const RenderOptions picture;
  CHECK_THROWS_AS(write_plot("furnace", {}, picture, folder / "plot.png", never), InputError);
  write_plot("furnace", {}, picture, folder / "plot.svg", never);
  CHECK(read_file(folder / "plot.svg").find("albedo 0.8") != std::string::npos);
}
