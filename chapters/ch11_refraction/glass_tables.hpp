/// @file
/// Energies, furnaces and times, as text.
#pragma once

#include <atomic>
#include <cstdio>
#include <string>

#include "ch07_fresnel/cost.hpp"
#include "ch11_refraction/glass_views.hpp"
#include "ch11_refraction/interface_energy.hpp"

namespace lt {

inline constexpr float glass_alphas[] = {0.05f, 0.1f, 0.3f, 0.6f, 1.0f};

// [energy-both-ways]
/// What surfaces of glass of index 1.5 reflect and let through together, from both sides.
/// @param steps  of the quadrature
[[nodiscard]] inline std::string energy_both_ways_table(int steps) {
  std::string text;
  for (const bool outside : {true, false}) {
    text += outside ? "from air    a 0.05     0.1     0.3     0.6       1\n"
                    : "from glass  a 0.05     0.1     0.3     0.6       1\n";
    for (const float mu : {1.0f, 0.9f, 0.7f, 0.5f, 0.3f, 0.2f, 0.1f, 0.05f, 0.02f}) {
      char cell[40];
      std::snprintf(cell, sizeof cell, "%-10.2f", mu);
      text += cell;
      for (const float alpha : glass_alphas) {
        const RoughGlass<> glass{{alpha}, outside ? 1.0f : 1.5f, outside ? 1.5f : 1.0f};
        std::snprintf(cell, sizeof cell, " %7.4f", interface_energy(glass, mu, steps).total());
        text += cell;
      }
      text += '\n';
    }
  }
  return text;
}
// [energy-both-ways]

// [furnace-table]
/// Mean radiance of balls of glass of index 1.5 under a sky of radiance 1, over the whole disk that
/// one sees: right, and with each mistake. After 50 events; the glow, after 8.
/// @param rays  for each ball
[[nodiscard]] inline std::string glass_furnace_table(int rays, std::uint64_t seed) {
  std::string text = "mean of a ball   a 0.002    0.1     0.3     1\n";
  for (const char* wrong :
       {"none", "twice", "printed", "root", "weight", "scale", "sides", "glow"}) {
    char cell[40];
    std::snprintf(cell, sizeof cell, "%-14s", wrong);
    text += cell;
    for (const float alpha : {0.002f, 0.1f, 0.3f, 1.0f}) {
      Studio studio{TexturedScene(Scene{{{vec3(0.0f), 1.0f}}, {}, {}}), even_sky(Rgb(1.0f))};
      studio.scene.looks[0].material = {.roughness = alpha, .ior = 1.5f, .attenuation = Rgb(0.0f)};
      GlassViewOptions show;
      show.wrong = wrong;
      // The glow has no limit: each event adds to it, and doubles its rarest samples.
      show.depth = show.wrong == "glow" ? 8 : 50;
      const AnyEstimator estimate = estimator_in(studio, show);
      double sum = 0;
      for (int i = 0; i < rays; ++i) {
        Pcg32 random = stream_for(seed, 0, 0, i);
        const vec2 place = uniform_disk(random.next_vec2());
        sum += double{estimate({{place, -3.0f}, {0.0f, 0.0f, 1.0f}}, random).g};
      }
      std::snprintf(cell, sizeof cell, " %7.3f", sum / rays);
      text += cell;
    }
    text += '\n';
  }
  return text;
}
// [furnace-table]

// [counting]
/// A scene that counts the rays that it is asked for.
struct CountingScene {
  const PackedScene& scene;
  mutable std::int64_t queries = 0;
};
[[nodiscard]] inline std::optional<Hit> closest_hit(const CountingScene& counting, const Ray& ray) {
  ++counting.queries;
  return closest_hit(counting.scene, ray);
}
[[nodiscard]] inline Surface surface_at(const CountingScene& counting, const Ray& ray, Hit hit) {
  return surface_at(counting.scene, ray, hit);
}
[[nodiscard]] inline Rgb background(const CountingScene& counting, vec3 direction) {
  return background(counting.scene, direction);
}
// [counting]

// [room-speed]
/// Closest-hit queries of the complete room at depth 12, from the far camera, on one thread: the
/// fastest of several pictures of 180 x 144 pixels.
/// @param turns    pictures
/// @param samples  per pixel
template <Scattering Model>
[[nodiscard]] std::string room_speed(const char* name, const TexturedScene& room,
                                     const Model& bsdf_at, int turns, int samples) {
  const PackedScene packed(room);
  double best = 1e30;
  std::int64_t queries = 0;
  for (int turn = 0; turn < turns; ++turn) {
    const CountingScene counting{packed};
    const auto estimate = [&](const Ray& ray, Pcg32& random) {
      return radiance_through_media(counting, bsdf_at, ray, 12, random);
    };
    Film film(180, 144);
    const ProcessorTimer timer;
    render(film, room_camera_far(), estimate, {.last = samples, .threads = 1}, false);
    best = std::min(best, timer.seconds());
    queries = counting.queries;
  }
  char line[120];
  const double paths = 180.0 * 144 * samples, count = static_cast<double>(queries);
  std::snprintf(line, sizeof line, "%-28s %5.2f queries/path  %5.0f ns/query  %5.2f million/s\n",
                name, count / paths, 1e9 * best / count, 1e-6 * count / best);
  return line;
}
// [room-speed]

/// Nanoseconds of each step, and how fast the room is, as text.
/// @param rounds  of each measurement; 200 take some seconds in all
[[nodiscard]] inline std::string glass_cost_table(int rounds) {
  CostInputs inputs;
  for (std::size_t i = 0; i < inputs.wi.size(); i += 2)
    inputs.wi[i].z = -inputs.wi[i].z;  // half of the light comes from the other side
  std::string text = costs_head;
  const auto row = [&](const char* name, const auto& bsdf) {
    text += costs_row(name, bsdf, inputs, rounds);
  };
  row("smooth glass", Glass{1.0f, 1.5f});
  row("rough glass, into", RoughGlass<>{{0.3f}, 1.0f, 1.5f});
  row("rough glass, out of", RoughGlass<>{{0.3f}, 1.5f, 1.0f});
  const int turns = std::min(5, rounds), samples = std::max(1, rounds / 50);
  const auto matt = [](const Surface& s) { return cosine_lambert_at(s); };
  const auto complete = [](const Surface& s) { return complete_bsdf_at(s); };
  const TexturedScene plain = three_sphere_room_plain();
  text += room_speed("room, no textures, matt", plain, matt, turns, samples);
  text += room_speed("room, no textures, complete", plain, complete, turns, samples);
  const TexturedScene textured = complete_room(256);
  text += room_speed("room, textures, matt", textured, matt, turns, samples);
  text += room_speed("room, textures, complete", textured, complete, turns, samples);
  return text;
}

/// @param name  energy, furnace or cost
[[nodiscard]] inline std::string glass_table_named(const std::string& name, std::uint64_t seed) {
  if (name == "energy") return energy_both_ways_table(200);
  return name == "furnace" ? glass_furnace_table(100'000, seed) : glass_cost_table(200);
}

}  // namespace lt
