#include "ch07_fresnel/smooth_room.hpp"

#include "ch05_rendering_equation/tests/program_checks.hpp"
#include "ch05_rendering_equation/tests/scenes.hpp"
#include "ch07_fresnel/views.hpp"
#include "common/testkit/catch.hpp"
#include "common/testkit/close_to.hpp"

using namespace lt;
using namespace lt::testing;

namespace {

const std::atomic<bool> never{false};

Film film_of(const SmoothViewOptions& show, int spp, std::uint64_t seed = 1) {
  Film film(50, 40);
  const TexturedScene scene = smooth_scene(show);
  render(film, smooth_camera(show), estimator_for(show, scene), {.last = spp, .seed = seed}, never);
  return film;
}

SmoothViewOptions small(const std::string& view, const std::string& wrong = "none") {
  SmoothViewOptions show;
  show.view = view;
  show.wrong = wrong;
  show.texels = 16;
  return show;
}

}  // namespace

TEST_CASE("smooth room: no sample is negative or infinite or NaN in any view") {
  for (const char* view : {"room", "glass", "metal", "water"})
    CHECK(summary(film_of(small(view), 32)).bad == 0);
}

TEST_CASE("smooth room: without mirrors and glass it is chapter 6's, bit for bit") {
  const TexturedScene scene = matt_room(16);
  for (int i = 0; i < 10'000; ++i) {
    const Ray ray = camera_ray(room_camera_far(), vec2(i % 100, i / 100), 100, 100);
    TexturedScene const& all = scene;
    Pcg32 a = stream_for(1, i, 0, 0), b = stream_for(1, i, 0, 0);
    // Paths that meet the metal ball differ: here it is left matt.
    const auto matt_at = [](const Surface& surface) -> SmoothBsdf {
      return {CosineLambert{surface.material.tint}};
    };
    REQUIRE(radiance_recursive(all, matt_at, ray, 6, a) ==
            radiance_recursive(all, cosine_lambert_at, ray, 6, b));
  }
}

TEST_CASE("smooth room: the clear sphere is glass of the index that is asked for") {
  const TexturedScene scene = smooth_room(16, 1.7f);
  CHECK(scene.looks[room::clear_sphere].material.ior == 1.7f);
  CHECK_FALSE(is_opaque(scene.looks[room::clear_sphere].material));
}

TEST_CASE("flooded room: the water faces up, every other object keeps its look") {
  const TexturedScene scene = flooded_room(16, 1.33f);
  const TexturedScene dry = smooth_room(16, 1.5f);
  REQUIRE(scene.looks.size() == scene.shapes.object_count());
  const Ray down{{1.5f, 2.0f, 0.5f}, {0.0f, -1.0f, 0.0f}};
  const auto hit = closest_hit(scene, down);
  REQUIRE(hit);
  const Surface surface = surface_at(scene, down, *hit);
  CHECK(surface.outside);
  CHECK(surface.point.position.y == close_to(1.2f, 1e-6));
  CHECK(surface.material.ior == 1.33f);
  CHECK_FALSE(is_opaque(surface.material));
  CHECK(scene.looks.back().material.ior == dry.looks.back().material.ior);  // the floor
  CHECK(scene.looks.back().color != nullptr);
  CHECK(scene.looks[room::ceiling].material.tint == dry.looks[room::ceiling].material.tint);
}

TEST_CASE("flooded room: what a diver sees straight up he sees 1.33 squared times as bright") {
  // The lamp through still water, with all of the light that is not reflected: (1 - F) n^2 Le, and
  // nothing else can come from a lamp that reflects nothing.
  TexturedScene scene = flooded_room(16, 1.33f);
  scene.looks[room::light].color = nullptr;
  const Ray up{{1.5f, 0.5f, 1.5f}, {0.0f, 1.0f, 0.0f}};
  const double f = std::pow(0.33 / 2.33, 2);
  RunningMean mean;
  for (int i = 0; i < 50'000; ++i) {
    Pcg32 random = stream_for(1, 0, 0, i);
    mean.add(radiance_recursive(scene, smooth_bsdf_at, up, 1, random).g);
  }
  CHECK(z_test(mean, (1 - f) * 1.33 * 1.33 * 40).agrees(1e-4));
}

TEST_CASE("smooth room: the picture is the same for any number of threads") {
  const TexturedScene scene = smooth_room(16, 1.5f);
  const auto film = [&](int threads) {
    Film made(33, 21);
    render(made, room_camera_far(), estimator_for({.depth = 8}, scene),
           {.last = 2, .threads = threads, .tile_size = 8}, never);
    return made;
  };
  const Film one = film(1), seven = film(7);
  require_same_samples(one, seven);
}
