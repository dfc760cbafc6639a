#include "ch02_ray_casting/views.hpp"

#include <numbers>

#include "ch02_ray_casting/tests/reference.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

Image picture(const std::string& view, int width, int height, int threads = 1) {
  const Stage stage = stage_for(view, "far", 72.0f);
  return draw(stage.scene, stage.camera, view_named(view), width, height, threads);
}

ivec2 size_of(const Image& image) {
  return {image.width(), image.height()};
}

glm::ivec3 codes_at(const Image& image, int x, int y) {
  const Rgb c = image.at(x, y);
  return {to_code(c.x), to_code(c.y), to_code(c.z)};
}

}  // namespace

TEST_CASE("views: a direction's colour has the codes 255 times half of one plus it") {
  const auto codes = [](vec3 direction) {
    const Rgb c = direction_color(direction);
    return glm::ivec3(to_code(c.x), to_code(c.y), to_code(c.z));
  };
  CHECK(codes({0, 0, -1}) == glm::ivec3(128, 128, 255));  // towards the viewer: z goes away
  CHECK(codes({0, 0, 1}) == glm::ivec3(128, 128, 0));
  CHECK(codes({1, 0, 0}) == glm::ivec3(255, 128, 128));
  CHECK(codes({0, -1, 0}) == glm::ivec3(128, 0, 128));
}

TEST_CASE("views: the normals of walls and floor are where they should be") {
  const Image image = picture("normals", 90, 72);
  CHECK(codes_at(image, 2, 36) == glm::ivec3(255, 128, 128));   // west wall faces east
  CHECK(codes_at(image, 87, 36) == glm::ivec3(0, 128, 128));    // east wall faces west
  CHECK(codes_at(image, 45, 70) == glm::ivec3(128, 255, 128));  // floor faces up
  CHECK(codes_at(image, 20, 2) == glm::ivec3(128, 0, 128));     // ceiling faces down
  CHECK(codes_at(image, 45, 28) == glm::ivec3(128, 128, 255));  // north wall faces us
}

TEST_CASE("views: every view draws a picture of the size asked for") {
  for (const std::string& name : view_names())
    for (const ivec2 size : {ivec2{1, 1}, ivec2{33, 65}, ivec2{64, 1}})
      CHECK(size_of(picture(name, size.x, size.y)) == size);
}

TEST_CASE("views: any number of threads draws the same picture") {
  for (const char* name : {"normals", "acne"}) {
    const Image one = picture(name, 150, 120, 1);
    for (const int threads : {2, 7}) {
      const Image many = picture(name, 150, 120, threads);
      int differences = 0;
      for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 150; ++x)
          differences += one.at(x, y) != many.at(x, y);
      CHECK(differences == 0);
    }
  }
}

TEST_CASE("views: parallel rays are a column of NaN for the careless and nothing for us") {
  const Image careless = picture("nan", 91, 72);
  const Image right = picture("normals", 91, 72);
  int white = 0;
  for (int y = 0; y < 72; ++y)
    for (int x = 0; x < 91; ++x) {
      const bool is_white = careless.at(x, y) == Rgb(1.0f);
      REQUIRE((!is_white || x == 45));  // the middle column of an odd width
      if (x != 45) REQUIRE(careless.at(x, y) == right.at(x, y));
      white += is_white;
    }
  CHECK(white > 36);
  CHECK(share_of(picture("nan", 90, 72), Rgb(1.0f)) == 0.0);  // an even width has no such column
}

TEST_CASE("views: a fifth of the points of the room hit themselves and none with leave()") {
  CHECK(share_of(picture("acne", 300, 240), self_hit_color) > 0.1);
  for (const char* camera : {"near", "far"}) {
    const Stage stage = stage_for("leave", camera, 72.0f);
    const Image image = draw(stage.scene, stage.camera, view_leave, 300, 240, 1);
    CHECK(share_of(image, self_hit_color) == 0.0);
  }
}

TEST_CASE("views: the sphere at 10 km is as large as it should be and only in the stable form") {
  // A disc of radius 1 in a picture 2.8 wide and 2.24 high: pi / 6.272 of the pixels.
  const double expected = std::numbers::pi / (2.8 * 2.24);
  CHECK(1 - share_of(picture("far", 280, 224), nothing) == Approx(expected).margin(0.01));
  CHECK(1 - share_of(picture("far-naive", 280, 224), nothing) > expected + 0.1);
}

TEST_CASE("views: depth is brighter nearer and black where nothing is") {
  Scene scene;
  scene.spheres = {{{0, 0, 3.25f}, 1.0f}, {{3, 0, 5.25f}, 1.0f}};
  const vec3 forward{0, 0, 1};
  const float near = view_depth(scene, Ray{{0, 0, 0}, forward}).x;
  const float far = view_depth(scene, Ray{{3, 0, 0}, forward}).x;
  CHECK(near > far);
  CHECK(to_code(near) == 217);  // (6.5 - 2.25) / 5 of 255
  CHECK(to_code(far) == 115);   // (6.5 - 4.25) / 5 of 255
  CHECK(view_depth(scene, Ray{{9, 0, 0}, forward}) == nothing);
}

TEST_CASE("views: depth lines are as wide for the eye however aslant the wall is") {
  // From 1 m above a plane t is 1 / cos(theta), which grows by t tan(theta) a radian. A line is
  // drawn where t is off a half metre by less than 0.0015 of that: 0.003 radians, at every t.
  Scene scene;
  scene.grounds = {{0.0f}};
  for (const double t : {1.5, 2.0, 3.0, 4.5, 6.0}) {
    const double step = 1e-5;  // radians
    int drawn = 0;
    for (int i = -400; i <= 400; ++i) {
      const double theta = std::acos(1 / t) + i * step;
      const Ray ray{{0, 1, 0}, vec3(std::sin(theta), -std::cos(theta), 0)};
      const double bright = std::min(1.0, (6.5 - 1 / std::cos(theta)) / 5);
      drawn += to_code(view_depth(scene, ray).x) < 0.8 * 255 * bright;  // a line has 0.6 of it
    }
    INFO("at " << t << " m");
    CHECK(drawn * step == Approx(0.003).epsilon(0.05));
  }
}
