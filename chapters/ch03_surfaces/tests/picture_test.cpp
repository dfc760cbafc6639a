// From rays to the chapter's pictures.
#include <cmath>
#include <numbers>
#include <vector>

#include "ch03_surfaces/views.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// White to the right of the camera, black to its left.
Rgb right_half(const Ray& ray) {
  return Rgb(ray.direction.x > 0.0f ? 1.0f : 0.0f);
}

}  // namespace

TEST_CASE("smooth picture: a pixel is the mean over its area") {
  const Image image = smooth_picture(Camera{}, 3, 1, 4, right_half);
  CHECK(image.at(0, 0) == Rgb(0.0f));
  CHECK(image.at(1, 0) == Rgb(0.5f));  // the edge halves the middle pixel
  CHECK(image.at(2, 0) == Rgb(1.0f));
}

TEST_CASE("smooth picture: with one point it is the one in the middle") {
  const Camera camera;
  const Image image =
      smooth_picture(camera, 7, 5, 1, [](const Ray& ray) { return Rgb(ray.direction); });
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x)
      CHECK(image.at(x, y) == camera_ray(camera, vec2(x, y) + 0.5f, 7, 5).direction);
}

TEST_CASE("headlight: white straight on, darker aslant, half at its reach, white on lamps") {
  Surface surface{{}, true, frame_around({0, 0, -1}), {}, Material{}};
  const Headlight lamp{0.8f, 3.0f};
  const Ray straight{{0, 0, 0}, {0, 0, 1}};
  const Ray aslant{{0, 0, 0}, normalize(vec3(std::sqrt(3.0f), 0, 1))};  // 60 degrees: cosine 1/2
  CHECK(lit(lamp, surface, straight, 0.0f).r == Approx(0.8));
  CHECK(lit(lamp, surface, aslant, 0.0f).r == Approx(0.4));
  CHECK(lit(lamp, surface, straight, 3.0f).r == Approx(0.4));
  surface.material.tint = {0.5f, 0.25f, 0.0f};
  CHECK(distance(lit(lamp, surface, straight, 0.0f), Rgb(0.4f, 0.2f, 0.0f)) < 1e-6f);
  surface.material.emission = Rgb(3.0f);
  CHECK(lit(lamp, surface, aslant, 2.0f) == Rgb(1.0f));
}

TEST_CASE("globe: with Greenwich in front the Gulf of Guinea is in the middle, tilted north-east") {
  const glm::quat rotation = globe_rotation(0.0f);
  const vec3 north_pole = rotate(rotation, {0, 1, 0});
  const double tilt = 23.4 * std::numbers::pi / 180;
  CHECK(north_pole.x == Approx(std::sin(tilt)).epsilon(1e-4));  // to the right
  CHECK(north_pole.y == Approx(std::cos(tilt)).epsilon(1e-4));
  CHECK(distance(rotate(rotation, {0, 0, -1}), vec3(0, 0, -1)) < 1e-6f);
}

TEST_CASE("globe: turned eastwards, the front moves to the right and the axis stays") {
  const vec3 front_before = rotate(globe_rotation(0.0f), {0, 0, -1});
  const vec3 front_after = rotate(globe_rotation(radians(10.0f)), {0, 0, -1});
  CHECK(front_after.x > front_before.x + 0.1f);
  const vec3 pole = rotate(globe_rotation(0.0f), {0, 1, 0});
  CHECK(distance(rotate(globe_rotation(2.0f), {0, 1, 0}), pole) < 1e-6f);
}

TEST_CASE("views: from the wall's place you look along the bricks") {
  // Bumps show where rays are nearly parallel to the wall: in the middle of the picture 0.34 m
  // towards it on 1.15 m along it, atan(0.34 / 1.15) = 16.5 degrees.
  const Scene room = three_sphere_room();
  const auto is_brick = [&](const Ray& ray) {
    const auto hit = closest_hit(room, ray);
    return hit && hit->object / 2 == room::north_wall / 2;
  };
  int bricks = 0;
  for (int x = 0; x < 90; ++x)
    bricks += is_brick(camera_ray(room_camera("wall"), vec2(x, 36) + 0.5f, 90, 72));
  CHECK(bricks > 45);  // more than half of the picture
  const Ray middle = camera_ray(room_camera("wall"), {45, 36}, 90, 72);
  CHECK(is_brick(middle));
  CHECK(std::asin(middle.direction.z) == Approx(std::atan(0.34 / 1.15)).epsilon(0.01));
}

TEST_CASE("views: every view makes a picture of light, finite and not negative") {
  SurfaceViewOptions options;
  options.width = 21;  // odd, because the thesis' program had a white column there
  options.height = 13;
  options.grid = 1;
  options.texels = 16;
  for (const std::string view :
       {"room", "uv", "normals", "globe", "spin", "balls", "seam", "maps", "filter"}) {
    CAPTURE(view);
    options.view = view;
    const Image image = make_picture(options);
    REQUIRE(image.width() == 21);
    bool is_light = true;
    float brightest = 0.0f;
    for (int y = 0; y < 13; ++y)
      for (int x = 0; x < 21; ++x)
        for (int c = 0; c < 3; ++c) {
          const float value = image.at(x, y)[c];
          is_light = is_light && std::isfinite(value) && value >= 0.0f;
          brightest = std::max(brightest, value);
        }
    CHECK(is_light);
    CHECK(brightest > 0.1f);
  }
}

TEST_CASE("views: where there is no wrong version the program says so") {
  SurfaceViewOptions options;
  options.wrong = true;
  options.view = "uv";
  CHECK_THROWS_AS(make_picture(options), InputError);
}
