#include "ch05_rendering_equation/render.hpp"

#include "ch05_rendering_equation/lit_room.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const std::atomic<bool> never{false};

// A picture whose sides are no multiple of a tile's.
Film room_film(const SampleRange& range, const std::atomic<bool>& cancel = never) {
  static const TexturedScene scene = matt_room(16);
  Film film(75, 61);
  render(film, room_camera_far(), lt::testing::uniform_estimator(scene, 4), range, cancel);
  return film;
}

bool are_same(const Film& a, const Film& b) {
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a.at(x, y).sum != b.at(x, y).sum || a.at(x, y).count != b.at(x, y).count) return false;
  return true;
}

}  // namespace

TEST_CASE("render: any number of threads and any tiles make the same bytes") {
  const Film one = room_film({.last = 3, .threads = 1, .tile_size = 32});
  for (const int threads : {1, 2, 3, 7, 16})
    for (const int tile_size : {8, 32}) {
      CAPTURE(threads, tile_size);
      CHECK(are_same(one, room_film({.last = 3, .threads = threads, .tile_size = tile_size})));
    }
}

TEST_CASE("render: another seed makes another picture and the same seed the same") {
  const Film one = room_film({.last = 2});
  CHECK(are_same(one, room_film({.last = 2})));
  CHECK_FALSE(are_same(one, room_film({.last = 2, .seed = 2})));
}

TEST_CASE("render: every pixel gets the samples that were asked for") {
  const FilmSummary counts = summary(room_film({.first = 5, .last = 8}));
  CHECK(counts.least == 3);
  CHECK(counts.most == 3);
}

TEST_CASE("render: samples lie evenly anywhere in their pixel") {
  // A camera that looks along z at a window of 8 x 6 m, 1 m for each pixel.
  Camera camera;
  camera.field_of_view = 2 * std::atan(4.0f);
  const auto film_place = [](const Ray& ray, Pcg32&) {
    const float x = 4.0f + ray.direction.x / ray.direction.z;
    const float within = x - std::floor(x);
    return Rgb(x, 3.0f - ray.direction.y / ray.direction.z, within * within);
  };
  Film film(8, 6);
  render(film, camera, film_place, {.last = 10'000}, never);
  const double standard_error = std::sqrt(1.0 / 12 / 10'000);
  const double of_squares = std::sqrt(4.0 / 45 / 10'000);  // E[u^4] - E[u^2]^2 = 1/5 - 1/9
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x) {
      const glm::dvec3 mean = film.at(x, y).sum / 10'000.0;
      REQUIRE(z_test(mean.x, standard_error, x + 0.5).agrees());
      REQUIRE(z_test(mean.y, standard_error, y + 0.5).agrees());
      REQUIRE(z_test(mean.z, of_squares, 1.0 / 3).agrees());
    }
}

TEST_CASE("render: when cancelled it finishes the pixel that it is at and no other") {
  // The tenth sample, the second of the third pixel, says stop.
  std::atomic<bool> cancel{false};
  std::atomic<int> calls{0};
  const auto estimate = [&](const Ray&, Pcg32&) {
    if (++calls == 10) cancel = true;
    return Rgb(1.0f);
  };
  Film film(64, 64);
  render(film, Camera(), estimate, {.last = 4, .threads = 1}, cancel);
  CHECK(calls == 12);
  for (int x = 0; x < 64; ++x)
    CHECK(film.at(x, 0).count == (x < 3 ? 4 : 0));
}

TEST_CASE("render: when cancelled on several threads each pixel has all of its samples or none") {
  std::atomic<bool> cancel{false};
  std::atomic<int> calls{0};
  const auto estimate = [&](const Ray&, Pcg32&) {
    if (++calls == 1000) cancel = true;
    return Rgb(1.0f);
  };
  Film film(64, 64);
  render(film, Camera(), estimate, {.last = 4, .threads = 7, .tile_size = 8}, cancel);
  CHECK(calls < 4 * 64 * 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      REQUIRE(film.at(x, y).count % 4 == 0);
  const std::atomic<bool> already{true};
  CHECK(summary(room_film({.last = 2}, already)).most == 0);
}
