// A picture on a wall must not be a mirror image. Each surface wears a texture whose four quarters
// have different colors, and is looked at as a visitor would.
#include <memory>

#include "ch02_ray_casting/camera.hpp"
#include "ch03_surfaces/surface.hpp"
#include "ch03_surfaces/three_sphere_room_surfaces.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

const Rgb top_left(1, 0, 0), top_right(0, 1, 0), bottom_left(0, 0, 1), bottom_right(1, 1, 1);

// Quarters of 16 x 16 texels.
Texture quarters() {
  Image texture(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      texture.at(x, y) =
          y < 16 ? (x < 16 ? top_left : top_right) : (x < 16 ? bottom_left : bottom_right);
  return std::make_shared<const Image>(std::move(texture));
}

// The room, empty, with white walls that wear the quarters.
TexturedScene room_of_quarters() {
  Scene shapes = three_sphere_room();
  for (Sphere& sphere : shapes.spheres)
    sphere.center += vec3(0, 50, 0);  // out of sight; their numbers stay
  TexturedScene scene(shapes);
  for (const std::uint32_t wall :
       {room::north_wall, room::west_wall, room::east_wall, room::ceiling})
    map_wall(scene, wall);
  const Texture texture = quarters();
  for (Look& look : scene.looks)
    look.color = texture;
  return scene;
}

// The color seen in a direction given in the viewer's own terms.
Rgb seen(const TexturedScene& scene, const Camera& camera, float right, float up) {
  const vec3 direction = camera.forward + right * camera.right + up * camera.up;
  const Ray ray{camera.position, normalize(direction)};
  const auto hit = closest_hit(scene.shapes, ray);
  REQUIRE(hit.has_value());
  return surface_at(scene, ray, *hit).material.tint;
}

void check_unmirrored(const TexturedScene& scene, const Camera& camera, float reach = 0.5f) {
  CHECK(seen(scene, camera, -reach, reach) == top_left);
  CHECK(seen(scene, camera, reach, reach) == top_right);
  CHECK(seen(scene, camera, -reach, -reach) == bottom_left);
  CHECK(seen(scene, camera, reach, -reach) == bottom_right);
}

constexpr vec3 middle(1.5f, 1.5f, 1.5f);

}  // namespace

TEST_CASE("orientation: each wall shows its picture upright and unmirrored") {
  const TexturedScene scene = room_of_quarters();
  check_unmirrored(scene, look_at(middle, {1.5f, 1.5f, 3.0f}));  // north
  check_unmirrored(scene, look_at(middle, {0.0f, 1.5f, 1.5f}));  // west
  check_unmirrored(scene, look_at(middle, {3.0f, 1.5f, 1.5f}));  // east
}

TEST_CASE("orientation: the ceiling shows its picture unmirrored to who leans back") {
  // Leaning back from looking north, the top of one's head points south.
  check_unmirrored(room_of_quarters(), look_at(middle, {1.5f, 3.0f, 1.5f}, {0, 0, -1}));
}

TEST_CASE("orientation: the ground shows its picture unmirrored to who looks down, facing north") {
  // One repetition covers x and z from 0 to 1.
  const Camera camera = look_at({0.5f, 1.0f, 0.5f}, {0.5f, 0.0f, 0.5f}, {0, 0, 1});
  check_unmirrored(room_of_quarters(), camera, 0.25f);
}

TEST_CASE("orientation: a sphere shows the middle of its picture to the south, unmirrored") {
  TexturedScene scene(Scene{{{middle, 1.0f}}, {}, {}});
  scene.looks[0].color = quarters();
  check_unmirrored(scene, look_at({1.5f, 1.5f, -2.0f}, middle), 0.1f);
}

TEST_CASE("orientation: two repeats show the picture four times") {
  TexturedScene scene = room_of_quarters();
  map_wall(scene, room::north_wall, {2.0f, 2.0f});
  // Looked at from close to the middle of one of the four.
  check_unmirrored(scene, look_at({0.75f, 2.25f, 2.0f}, {0.75f, 2.25f, 3.0f}), 0.3f);
  check_unmirrored(scene, look_at({2.25f, 0.75f, 2.0f}, {2.25f, 0.75f, 3.0f}), 0.3f);
}

TEST_CASE("orientation: a wall's two triangles agree along their common edge") {
  const TexturedScene scene = room_of_quarters();
  const Scene& shapes = scene.shapes;
  for (std::size_t i = 0; i < shapes.triangles.size(); i += 2)
    for (const float s : {0.1f, 0.5f, 0.9f}) {
      const Triangle& upper = shapes.triangles[i];
      const vec3 point = glm::mix(upper.corner(0), upper.corner(2), s);
      const auto a = texture_point(scene.triangle_mappings[i], upper, point);
      const auto b = texture_point(scene.triangle_mappings[i + 1], shapes.triangles[i + 1], point);
      CHECK(distance(a.uv, b.uv) < 1e-6f);
      CHECK(distance(normalize(a.tangent), normalize(b.tangent)) < 1e-6f);
    }
}
