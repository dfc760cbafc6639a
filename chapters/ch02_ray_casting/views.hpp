/// @file
/// What a picture can show before there is light: which object, which way it faces, how far it is.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ch01_pixels/image.hpp"
#include "ch02_ray_casting/mistakes.hpp"
#include "ch02_ray_casting/surface_point.hpp"
#include "ch02_ray_casting/three_sphere_room.hpp"
#include "common/parallel.hpp"

namespace lt {

/// The colour at the end of a ray.
using View = Rgb (*)(const Scene&, const Ray&);

inline constexpr Rgb nothing{0.0f};

// [as-code]
/// Data as a colour. Numbers are not light, so they go into the file's *codes*: code 255 * `data`,
/// which is what a colour picker reads back. (Stored as light, 0.5 would become code 188.)
/// @param data  0 to 1 each
[[nodiscard]] inline Rgb as_code(vec3 data) {
  return {decode_srgb(data.x), decode_srgb(data.y), decode_srgb(data.z)};
}

/// A direction as a colour: red to the right, green up, blue towards the viewer, from -1 to 1.
[[nodiscard]] inline Rgb direction_color(vec3 direction) {
  return as_code(0.5f * (vec3(direction.x, direction.y, -direction.z) + 1.0f));
}
// [as-code]

[[nodiscard]] inline Rgb view_rays(const Scene&, const Ray& ray) {
  return direction_color(ray.direction);
}

/// One flat colour for each object. The two triangles of a wall differ a little.
[[nodiscard]] inline Rgb view_silhouettes(const Scene& scene, const Ray& ray) {
  static constexpr std::array<vec3, 13> colors{{{1.00f, 0.93f, 0.72f},
                                                {0.62f, 0.82f, 0.95f},
                                                {0.91f, 0.69f, 0.24f},
                                                {0.33f, 0.71f, 0.46f},
                                                {0.72f, 0.45f, 0.40f},
                                                {0.66f, 0.40f, 0.36f},
                                                {0.34f, 0.52f, 0.55f},
                                                {0.30f, 0.47f, 0.50f},
                                                {0.55f, 0.40f, 0.58f},
                                                {0.50f, 0.36f, 0.53f},
                                                {0.55f, 0.56f, 0.58f},
                                                {0.49f, 0.50f, 0.52f},
                                                {0.36f, 0.35f, 0.37f}}};
  const auto hit = closest_hit(scene, ray);
  return hit ? as_code(colors[hit->object % colors.size()]) : nothing;
}

// [view-normals]
[[nodiscard]] inline Rgb view_normals(const Scene& scene, const Ray& ray) {
  const auto hit = closest_hit(scene, ray);
  return hit ? direction_color(surface_point(scene, ray, *hit).normal) : nothing;
}
// [view-normals]

/// From white at 1.5 m to black at 6.5 m, with a line at every half metre, as wide for the eye on
/// every wall: turn by a small angle, and t changes by the angle times t tan(theta), theta between
/// ray and normal. A band of a fixed depth would fall apart into dashes on walls seen aslant.
[[nodiscard]] inline Rgb view_depth(const Scene& scene, const Ray& ray) {
  const auto hit = closest_hit(scene, ray);
  if (!hit) return nothing;
  const float bright = std::clamp((6.5f - hit->t) / 5.0f, 0.0f, 1.0f);

  const vec3 normal = surface_point(scene, ray, *hit).normal;
  const float tangent = length(cross(ray.direction, normal)) / std::abs(dot(ray.direction, normal));
  const float off_line = std::abs(hit->t - 0.5f * std::round(2.0f * hit->t));
  const bool is_line = off_line < 0.0015f * hit->t * tangent;  // half of 0.003 radians
  return as_code(vec3(is_line ? 0.6f * bright : bright));
}

/// The color of points that hit themselves.
inline const Rgb self_hit_color = as_code({1.0f, 0.35f, 0.1f});

/// Sends each ray on like a mirror and asks: does it hit the very surface that it leaves?
[[nodiscard]] inline Rgb view_bounce(const Scene& scene, const Ray& ray, bool with_offset) {
  const auto hit = closest_hit(scene, ray);
  if (!hit) return nothing;
  const SurfacePoint point = surface_point(scene, ray, *hit);
  const float cosine = -dot(ray.direction, point.normal);
  const vec3 mirrored = ray.direction + 2.0f * cosine * point.normal;

  const Ray next = with_offset ? leave(point, mirrored) : Ray{ray.at(hit->t), mirrored};
  const auto next_hit = closest_hit(scene, next);
  if (next_hit && next_hit->object == hit->object) return self_hit_color;
  return as_code(vec3(0.2f + 0.6f * std::abs(cosine)));
}

[[nodiscard]] inline Rgb view_acne(const Scene& scene, const Ray& ray) {
  return view_bounce(scene, ray, false);
}
[[nodiscard]] inline Rgb view_leave(const Scene& scene, const Ray& ray) {
  return view_bounce(scene, ray, true);
}

/// Normals, as far as the careless search finds any; NaN is white.
[[nodiscard]] inline Rgb view_nan(const Scene& scene, const Ray& ray) {
  const auto hit = mistakes::closest_hit(scene, ray);
  if (!hit) return nothing;
  if (!std::isfinite(hit->t)) return Rgb(1.0f);
  return direction_color(surface_point(scene, ray, *hit).normal);
}

/// The normals of one sphere found by the school formula.
[[nodiscard]] inline Rgb view_far_naive(const Scene& scene, const Ray& ray) {
  const auto t = mistakes::intersect(scene.spheres.at(0), ray, infinity);
  return t ? direction_color(surface_point(scene, ray, {*t, 0}).normal) : nothing;
}

/// Every view by its name on the command line.
inline constexpr std::array<std::pair<const char*, View>, 9> views{
    {{"rays", view_rays},
     {"silhouettes", view_silhouettes},
     {"normals", view_normals},
     {"depth", view_depth},
     {"acne", view_acne},
     {"leave", view_leave},
     {"nan", view_nan},
     {"far", view_normals},
     {"far-naive", view_far_naive}}};

[[nodiscard]] inline std::vector<std::string> view_names() {
  std::vector<std::string> names;
  for (const auto& [name, view] : views)
    names.emplace_back(name);
  return names;
}

/// The views that show the room, where you stand as you please.
[[nodiscard]] inline std::vector<std::string> room_view_names() {
  std::vector<std::string> names = view_names();
  std::erase_if(names, [](const std::string& name) { return name.starts_with("far"); });
  return names;
}

/// @param name  one of view_names()
[[nodiscard]] inline View view_named(const std::string& name) {
  return std::ranges::find(views, name, &std::pair<const char*, View>::first)->second;
}

/// What a view looks at, and from where.
struct Stage {
  Scene scene;
  Camera camera;
};

/// A sphere of 1 m, 10 km away, through the telescope that fills the picture with it.
[[nodiscard]] inline Stage far_sphere() {
  const vec3 center = 1e4f * normalize(vec3(2.0f, 1.0f, 3.0f));
  Stage stage{{{{center, 1.0f}}, {}, {}}, look_at(vec3(0.0f), center)};
  stage.camera.field_of_view = 2.0f * std::atan(1.4f / 1e4f);
  return stage;
}

/// @param camera         "near" or "far", for the room
/// @param field_of_view  degrees, for the room
[[nodiscard]] inline Stage stage_for(const std::string& view, const std::string& camera,
                                     float field_of_view) {
  if (view.starts_with("far")) return far_sphere();
  Stage stage{three_sphere_room(), camera == "near" ? room_camera_near() : room_camera_far()};
  stage.camera.field_of_view = radians(field_of_view);
  return stage;
}

// [draw]
/// One ray through the middle of every pixel.
[[nodiscard]] inline Image draw(const Scene& scene, const Camera& camera, View view, int width,
                                int height, int threads) {
  Image image(width, height);
  for_each_tile(width, height, threads, [&](const Tile& tile) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x)
        image.at(x, y) = view(scene, camera_ray(camera, vec2(x, y) + 0.5f, width, height));
  });
  return image;
}
// [draw]

/// The share of an image's pixels that have exactly this color, 0 to 1.
[[nodiscard]] inline double share_of(const Image& image, const Rgb& color) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      count += image.at(x, y) == color;
  return static_cast<double>(count) / image.width() / image.height();
}

}  // namespace lt
