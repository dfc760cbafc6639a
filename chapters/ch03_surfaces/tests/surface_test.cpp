// The surface of the winner: texel, frame, side.
#include "ch03_surfaces/surface.hpp"

#include <memory>

#include "ch03_surfaces/mistakes.hpp"
#include "ch03_surfaces/tests/random_input.hpp"
#include "ch03_surfaces/three_sphere_room_surfaces.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

constexpr vec3 center(0.2f, -0.1f, 4.0f);

TexturedScene one_sphere() {
  return TexturedScene(Scene{{{center, 1.5f}}, {}, {}});
}

Texture one_color(Rgb color) {
  return std::make_shared<const Image>(1, 1, color);
}

// Bumps in all directions.
Texture bumps() {
  RandomInput random(9);
  Image normals(8, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      normals.at(x, y) = {random.uniform(0.2f, 0.8f), random.uniform(0.2f, 0.8f), 0.9f};
  return std::make_shared<const Image>(std::move(normals));
}

Surface seen(const TexturedScene& scene, const Ray& ray) {
  const auto hit = closest_hit(scene.shapes, ray);
  REQUIRE(hit.has_value());
  return surface_at(scene, ray, *hit);
}

Ray from_outside(RandomInput& random) {
  const vec3 origin = center + 5.0f * random.direction();
  return {origin, normalize(center + random.direction() - origin)};
}

}  // namespace

TEST_CASE("surface: a plain object has its material, its normal, and a frame around it") {
  TexturedScene scene = one_sphere();
  scene.looks[0].material = {.tint = {0.1f, 0.2f, 0.3f}, .roughness = 0.4f};
  const Surface surface = seen(scene, {{0.2f, -0.1f, 0}, {0, 0, 1}});
  CHECK(surface.material.tint == Rgb(0.1f, 0.2f, 0.3f));
  CHECK(surface.material.roughness == 0.4f);
  CHECK(surface.frame.normal == surface.point.normal);
  CHECK(distance(surface.frame.normal, vec3(0, 0, -1)) < 1e-6f);
  CHECK(distance(cross(surface.frame.tangent, surface.frame.bitangent), vec3(0, 0, -1)) < 1e-6f);
  CHECK(surface.outside);
}

TEST_CASE("surface: with a texture of either kind the frame lies as the texture does") {
  for (const bool is_color : {true, false}) {
    TexturedScene scene = one_sphere();
    (is_color ? scene.looks[0].color : scene.looks[0].normals) = one_color({0.5f, 0.5f, 1.0f});
    const Surface surface = seen(scene, {{0.2f, -0.1f, 0}, {0, 0, 1}});
    CHECK(distance(surface.frame.tangent, vec3(1, 0, 0)) < 1e-6f);     // east is right
    CHECK(distance(surface.frame.bitangent, vec3(0, -1, 0)) < 1e-6f);  // south is down
    CHECK(distance(surface.uv, vec2(0.5f, 0.5f)) < 1e-6f);             // seen from the front
  }
}

TEST_CASE("surface: the texel multiplies tint and emission, and nothing else") {
  TexturedScene scene = one_sphere();
  scene.looks[0].material = {.emission = {8, 8, 8}, .tint = Rgb(0.5f), .attenuation = Rgb(3.0f)};
  scene.looks[0].color = one_color({0.25f, 0.5f, 1.0f});
  const Surface surface = seen(scene, {{0.2f, -0.1f, 0}, {0, 0, 1}});
  CHECK(distance(surface.material.tint, Rgb(0.125f, 0.25f, 0.5f)) < 1e-6f);
  CHECK(distance(surface.material.emission, Rgb(2, 4, 8)) < 1e-5f);
  CHECK(surface.material.attenuation == Rgb(3.0f));
}

TEST_CASE("surface: a flat normal map changes nothing") {
  TexturedScene plain = one_sphere();
  plain.looks[0].color = one_color(Rgb(1.0f));  // white changes nothing, but makes it lie
  TexturedScene mapped = plain;
  mapped.looks[0].normals = one_color({0.5f, 0.5f, 1.0f});
  RandomInput random(1);
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = from_outside(random);
    if (!closest_hit(plain.shapes, ray)) continue;
    CHECK(distance(seen(plain, ray).frame.normal, seen(mapped, ray).frame.normal) < 1e-6f);
    CHECK(distance(seen(plain, ray).frame.tangent, seen(mapped, ray).frame.tangent) < 1e-5f);
  }
}

TEST_CASE("surface: a rotated sphere's relief turns with it") {
  TexturedScene straight = one_sphere();
  straight.looks[0].normals = bumps();
  TexturedScene turned = straight;
  RandomInput random(2);
  for (int i = 0; i < 1000; ++i) {
    const glm::quat q = random.rotation();
    turned.sphere_mappings[0].rotation = q;
    const Ray ray = from_outside(random);
    if (!closest_hit(straight.shapes, ray)) continue;
    // Turn the sphere and the ray by the same rotation about the center: nothing else may change.
    const Ray turned_ray{center + rotate(q, ray.origin - center), rotate(q, ray.direction)};
    const Surface before = seen(straight, ray);
    if (std::abs(before.point.normal.y) > 0.99f) continue;  // at the poles east is rounding
    const Surface after = seen(turned, turned_ray);
    CHECK(distance(after.frame.normal, rotate(q, before.frame.normal)) < 1e-3f);
    CHECK(distance(after.frame.tangent, rotate(q, before.frame.tangent)) < 1e-3f);
  }
}

TEST_CASE("surface: the planted mistake leaves the relief behind") {
  TexturedScene scene = one_sphere();
  scene.looks[0].normals = one_color({0.5f, 0.5f, 1.0f});  // flat: the normal is the sphere's
  scene.sphere_mappings[0].rotation = rotation_about({0, 1, 0}, pi / 2.0f);
  const Ray ray{{0.2f, -0.1f, 0}, {0, 0, 1}};
  const Hit hit = closest_hit(scene.shapes, ray).value();
  CHECK(distance(surface_at(scene, ray, hit).frame.normal, vec3(0, 0, -1)) < 1e-6f);
  const vec3 wrong = mistakes::surface_with_local_normal(scene, ray, hit).frame.normal;
  CHECK(distance(wrong, vec3(1, 0, 0)) < 1e-6f);  // a quarter turn off
}

TEST_CASE("surface: from inside, the shading normal faces the viewer and the geometric one not") {
  TexturedScene scene = one_sphere();
  scene.looks[0].normals = bumps();
  RandomInput random(3);
  for (int i = 0; i < 1000; ++i) {
    const Ray ray{center + 0.5f * random.direction(), random.direction()};
    const Surface surface = seen(scene, ray);
    CHECK_FALSE(surface.outside);
    CHECK(dot(surface.point.normal, surface.point.position - center) > 0.0f);
    CHECK(dot(surface.frame.normal, ray.direction) < 0.0f);
    const Frame& f = surface.frame;
    CHECK(distance(cross(f.tangent, f.bitangent), f.normal) < 1e-5f);
  }
}

TEST_CASE("surface: a bump seen from behind is a dent") {
  TexturedScene scene = one_sphere();
  scene.looks[0].normals = one_color({0.7f, 0.4f, 0.9f});
  const Surface outside = seen(scene, {{0.2f, -0.1f, 0}, {0, 0, 1}});
  const Surface inside = seen(scene, {{0.2f, -0.1f, 4}, {0, 0, -1}});
  REQUIRE(distance(outside.point.position, inside.point.position) < 1e-5f);
  CHECK(distance(inside.frame.normal, -outside.frame.normal) < 1e-5f);
}

TEST_CASE("surface: in the textured room every ray finds a unit normal on the viewer's side") {
  const TexturedScene scene = three_sphere_room_textured(64);
  RandomInput random(4);
  for (int i = 0; i < 50'000; ++i) {
    const vec3 origin(random.uniform(0.1f, 2.9f), random.uniform(1.5f, 2.4f), -0.3f);
    const Ray ray{origin, random.direction()};
    const auto hit = closest_hit(scene.shapes, ray);
    if (!hit) continue;
    const Surface surface = surface_at(scene, ray, *hit);
    REQUIRE(length(surface.frame.normal) == Approx(1.0).margin(1e-5));
    REQUIRE(dot(surface.frame.normal, ray.direction) < 1e-6f);
    REQUIRE(glm::all(glm::greaterThanEqual(surface.material.tint, vec3(0.0f))));
    REQUIRE(glm::all(glm::lessThanEqual(surface.material.tint, vec3(1.0f))));
  }
}

TEST_CASE("surface: it is looked up for the winner alone") {
  // The search carries distance and number, nothing to shade with.
  static_assert(sizeof(Hit) == sizeof(float) + sizeof(std::uint32_t));
  TexturedScene scene = one_sphere();
  scene.looks[0].color = one_color({0.1f, 0.2f, 0.3f});
  TexturedScene crowded(Scene{{{center, 1.5f}, {center + vec3(0, 0, 9), 3.0f}}, {}, {{-2.0f}}});
  crowded.looks[0] = scene.looks[0];
  // What is behind the winner has a texture without texels: whoever asks it, fails.
  crowded.looks[1].color = crowded.looks[2].color = std::make_shared<const Image>();
  const Ray ray{{0.2f, -0.1f, 0}, {0, 0, 1}};
  CHECK(seen(crowded, ray).material.tint == seen(scene, ray).material.tint);
}
