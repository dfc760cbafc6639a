#include "ch05_rendering_equation/lit_room.hpp"

#include "ch05_rendering_equation/progressive.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const std::atomic<bool> never{false};

const TexturedScene& room_scene() {
  static const TexturedScene scene = matt_room(64);
  return scene;
}

}  // namespace

TEST_CASE("lit room: no sample is negative or infinite or NaN at 64 samples per pixel") {
  for (const Camera& camera : {room_camera_far(), room_camera_near()}) {
    Film film(50, 40);
    render(film, camera, lt::testing::uniform_estimator(room_scene(), 8), {.last = 64}, never);
    CHECK(summary(film).bad == 0);
    CHECK_NOTHROW(require_good_samples(film));
  }
}

TEST_CASE("lit room: no surface gives back more light than it gets and only the lamp shines") {
  for (std::size_t i = 0; i < room_scene().looks.size(); ++i) {
    const Material& material = room_scene().looks[i].material;
    for (int c = 0; c < 3; ++c) {
      CHECK(material.tint[c] > 0.0f);  // the clear sphere's 0 would be a black ball
      CHECK(material.tint[c] <= 1.0f);
    }
    CHECK(is_emissive(material) == (i == room::light));
  }
}

TEST_CASE("lit room: with the same random numbers one event more never takes light away") {
  const Camera camera = room_camera_far();
  for (int i = 0; i < 20'000; ++i) {
    Pcg32 place = stream_for(1, i, 0, 0);
    const Ray ray = camera_ray(camera, place.next_vec2() * vec2(100, 80), 100, 80);
    float last = -1.0f;
    for (int depth = 0; depth <= 4; ++depth) {
      Pcg32 random = stream_for(2, i, 0, 0);
      const float now = radiance_recursive(room_scene(), uniform_lambert_at, ray, depth, random).g;
      REQUIRE(now >= last);
      last = now;
    }
  }
}

TEST_CASE("lit room: at depth 0 only the lamp is seen") {
  Film film(100, 80);
  render(film, room_camera_far(), lt::testing::uniform_estimator(room_scene(), 0), {.last = 4},
         never);
  const Image image = developed(film);
  CHECK(image.at(50, 80 * 3 / 20) == Rgb(45.0f, 40.0f, 30.0f));
  CHECK(image.at(50, 60) == Rgb(0.0f));
  CHECK(image.at(5, 40) == Rgb(0.0f));
}
