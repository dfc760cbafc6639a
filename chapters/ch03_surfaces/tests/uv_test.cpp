// Texture coordinates on spheres, triangles and the ground.
#include "ch03_surfaces/uv.hpp"

#include <cmath>

#include "ch03_surfaces/tests/random_input.hpp"
#include "common/testkit/catch.hpp"

using namespace lt;

namespace {

// Where longitude and latitude say the point is: the formula of sphere_uv() read backwards.
vec3 normal_at_uv(vec2 uv) {
  const float longitude = 2.0f * pi * (uv.x - 0.5f);
  const float from_pole = pi * uv.y;
  return {std::sin(from_pole) * std::sin(longitude), std::cos(from_pole),
          -std::sin(from_pole) * std::cos(longitude)};
}

const Triangle wall({0, 3, 3}, {3, 3, 3}, {3, 0, 3});  // upper half of the north wall

}  // namespace

TEST_CASE("sphere uv: the six points on the axes") {
  CHECK(distance(sphere_uv({0, 0, -1}), vec2(0.5f, 0.5f)) < 1e-6f);   // the front: the middle
  CHECK(distance(sphere_uv({1, 0, 0}), vec2(0.75f, 0.5f)) < 1e-6f);   // right, as seen from -z
  CHECK(distance(sphere_uv({-1, 0, 0}), vec2(0.25f, 0.5f)) < 1e-6f);  // left
  CHECK(sphere_uv({0, 1, 0}).y == 0.0f);                              // north pole: upper edge
  CHECK(sphere_uv({0, -1, 0}).y == Approx(1.0));                      // south pole: lower edge
  const float back = sphere_uv({0, 0, 1}).x;                          // on the seam: either end
  CHECK(std::min(back, 1.0f - back) == Approx(0.0).margin(1e-6));
}

TEST_CASE("sphere uv: reading the formula backwards returns to the point") {
  RandomInput random(1);
  float worst = 0.0f;
  for (int i = 0; i < 100'000; ++i) {
    const vec3 n = random.direction();
    worst = std::max(worst, distance(normal_at_uv(sphere_uv(n)), n));
  }
  // Near the poles acos loses half of the digits: sqrt(2^-24) = 2e-4.
  CHECK(worst < 5e-4f);
}

TEST_CASE("sphere uv: poles, seam and normals a hair too long are in 0 to 1") {
  for (const float tiny : {0.0f, -0.0f, 1e-30f, -1e-30f, 1e-7f, -1e-7f})
    for (const vec3 n : {vec3(tiny, 1.0f, 0.0f), vec3(0.0f, -1.0f, tiny), vec3(tiny, 0.0f, 1.0f),
                         vec3(tiny, 1.0000002f, tiny), vec3(0.0f, -1.0000002f, -tiny)}) {
      const vec2 uv = sphere_uv(n);
      CAPTURE(n, uv);
      CHECK((uv.x >= 0.0f && uv.x <= 1.0f && uv.y >= 0.0f && uv.y <= 1.0f));
    }
}

TEST_CASE("sphere mapping: u grows along the tangent, v along cross of normal and tangent") {
  RandomInput random(2);
  const float step = 1e-3f;
  for (int i = 0; i < 1000; ++i) {
    const SphereMapping mapping{{0.0f, 0.0f}, {1.0f, 1.0f}, random.rotation()};
    const float u = random.uniform(0.05f, 0.95f);  // not across the seam
    const vec2 uv(u, random.uniform(0.2f, 0.8f));  // not at the poles
    const vec3 n = rotate(mapping.rotation, normal_at_uv(uv));
    const vec3 tangent = normalize(texture_point(mapping, n).tangent);
    const auto moved = [&](vec3 direction) {
      return texture_point(mapping, normalize(n + step * direction)).uv -
             texture_point(mapping, n).uv;
    };
    // Once around a parallel, 2 pi sin(pi v) long, u grows by 1; from pole to pole, pi, so does v.
    CHECK(moved(tangent).x == Approx(step / (2 * pi * std::sin(pi * uv.y))).epsilon(0.02));
    CHECK(moved(tangent).y == Approx(0.0).margin(1e-5));
    CHECK(moved(cross(n, tangent)).x == Approx(0.0).margin(1e-5));
    CHECK(moved(cross(n, tangent)).y == Approx(step / pi).epsilon(0.02));
  }
}

TEST_CASE("sphere mapping: the texture goes round with the sphere") {
  RandomInput random(3);
  for (int i = 0; i < 1000; ++i) {
    const SphereMapping turned{{0.0f, 0.0f}, {1.0f, 1.0f}, random.rotation()};
    const vec3 n = normal_at_uv({random.uniform(0.05f, 0.95f), random.uniform(0.1f, 0.9f)});
    CHECK(distance(texture_point(turned, rotate(turned.rotation, n)).uv, sphere_uv(n)) < 1e-5f);
  }
}

TEST_CASE("sphere mapping: a turn about y by a moves u by a / 2 pi") {
  // About y, positive angles turn z to x: the front goes left, and what was right of it comes.
  const SphereMapping turned{{0, 0}, {1, 1}, rotation_about({0, 1, 0}, radians(36.0f))};
  CHECK(distance(texture_point(turned, {0, 0, -1}).uv, vec2(0.6f, 0.5f)) < 1e-6f);
}

TEST_CASE("sphere mapping: texture corners choose the part that is stretched over the sphere") {
  const SphereMapping part{{0.25f, 0.5f}, {0.75f, 1.5f}};
  CHECK(distance(texture_point(part, {0, 0, -1}).uv, vec2(0.5f, 1.0f)) < 1e-6f);
  CHECK(texture_point(part, {0, 1, 0}).uv.y == 0.5f);
  CHECK(texture_point(part, {0, -1, 0}).uv.y == Approx(1.5));
  CHECK(texture_point(part, normalize(vec3(-1e-6f, 0, 1))).uv.x == Approx(0.25));
  CHECK(texture_point(part, normalize(vec3(1e-6f, 0, 1))).uv.x == Approx(0.75));
}

TEST_CASE("triangle mapping: corners have their uv, the middle has the mean") {
  const TriangleMapping mapping{{{0.1f, 0.2f}, {0.9f, 0.3f}, {0.8f, 0.7f}}};
  for (int i = 0; i < 3; ++i)
    CHECK(distance(texture_point(mapping, wall, wall.corner(i)).uv, mapping.corner[i]) < 1e-6f);
  CHECK(distance(texture_point(mapping, wall, {2, 2, 3}).uv, vec2(0.6f, 0.4f)) < 1e-6f);
}

TEST_CASE("triangle mapping: along the tangent u grows and v stays, however the texture lies") {
  RandomInput random(4);
  for (int i = 0; i < 1000; ++i) {
    // Stretched, sheared and turned, but not mirrored.
    const vec2 corner = random.point(-1.0f, 1.0f);
    const vec2 right = random.point(-1.0f, 1.0f);
    const vec2 down = vec2(-right.y, right.x) + 0.5f * right;
    const TriangleMapping mapping{{corner, corner + right, corner + right + down}};
    const vec3 middle(2, 2, 3);
    const TexturePoint here = texture_point(mapping, wall, middle);
    const vec3 step = 0.1f * normalize(here.tangent);
    const vec2 moved = texture_point(mapping, wall, middle + step).uv - here.uv;
    CHECK(moved.x > 0.0f);
    CHECK(moved.y == Approx(0.0).margin(1e-6));
  }
}

TEST_CASE("triangle mapping: with one uv at all corners there is no tangent, and no NaN") {
  const TriangleMapping point{{{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}};
  const TexturePoint here = texture_point(point, wall, {2, 2, 3});
  CHECK(here.uv == vec2(0.5f, 0.5f));
  CHECK(here.tangent == vec3(0.0f));
}

TEST_CASE("ground mapping: +x is right, +z is up, and the texture repeats") {
  const GroundMapping mapping{{0, 0}, {1, 1}, 2.0f};  // a repetition is 2 m wide
  CHECK(distance(texture_point(mapping, {0.5f, 0, 0.5f}).uv, vec2(0.25f, 0.75f)) < 1e-6f);
  CHECK(distance(texture_point(mapping, {2.5f, 0, 4.5f}).uv, vec2(0.25f, 0.75f)) < 1e-6f);
  CHECK(distance(texture_point(mapping, {-1.5f, 0, -7.5f}).uv, vec2(0.25f, 0.75f)) < 1e-6f);
  CHECK(texture_point(mapping, {1.5f, 0, 0.5f}).uv.x > 0.25f);  // farther right
  CHECK(texture_point(mapping, {0.5f, 0, 1.5f}).uv.y < 0.75f);  // farther up
  CHECK(texture_point(mapping, {0.5f, 0, 0.5f}).tangent == vec3(1, 0, 0));
}

TEST_CASE("ground mapping: texture corners choose the part that is repeated") {
  const GroundMapping part{{0.5f, 0.0f}, {1.0f, 0.5f}, 1.0f};
  CHECK(distance(texture_point(part, {0.5f, 0, 0.5f}).uv, vec2(0.75f, 0.25f)) < 1e-6f);
  CHECK(distance(texture_point(part, {7.5f, 0, -3.5f}).uv, vec2(0.75f, 0.25f)) < 1e-6f);
}
