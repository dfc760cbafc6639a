/// @file
/// What Fresnel's equations and the choice between kinds cost, measured.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "ch04_monte_carlo/pcg32.hpp"
#include "ch04_monte_carlo/streams.hpp"
#include "ch05_rendering_equation/lit_room.hpp"
#include "ch07_fresnel/schlick.hpp"
#include "ch07_fresnel/smooth.hpp"
#include "common/timing.hpp"

namespace lt {

/// Processor time of one call of f(i), i = 0 to 4095 again and again, nanoseconds.
/// @param f       gives a number, not negative
/// @param rounds  how many times 4096 calls
template <class F>
[[nodiscard]] double nanoseconds(const F& f, int rounds) {
  return best_nanoseconds(4096 * rounds,
                          [&](int i) { return f(static_cast<std::size_t>(i % 4096)); });
}

/// All of a sample, added up, so that no part of it is left out.
template <Bsdf AnyBsdf>
[[nodiscard]] float sampled(const AnyBsdf& bsdf, vec3 wo, vec3 u) {
  const auto sample = bsdf.sample(wo, u);
  return sample ? dot(abs(sample->wi) + sample->weight, vec3(1.0f)) : 0.0f;
}

// [path-cost]
/// Nanoseconds of a path through chapter 5's matt room, depth 8, on one thread.
template <Scattering Model>
[[nodiscard]] double path_nanoseconds(const TexturedScene& scene, const Model& bsdf_at,
                                      int rounds) {
  const auto path = [&](std::size_t i) {
    Pcg32 random = stream_for(1, static_cast<int>(i), 0, 0);
    const vec2 film = random.next_vec2() * 64.0f;
    return radiance_recursive(scene, bsdf_at, camera_ray(room_camera_far(), film, 64, 64), 8,
                              random)
        .g;
  };
  return nanoseconds(path, rounds);
}
// [path-cost]

/// 4096 directions above the surface, and as many points to sample with: what costs are measured
/// on.
struct CostInputs {
  std::vector<vec3> wo, wi, u;

  CostInputs() {
    Pcg32 random(1);
    for (std::size_t i = 0; i < 4096; ++i) {
      wo.push_back(uniform_hemisphere(random.next_vec2()));
      wi.push_back(uniform_hemisphere(random.next_vec2()));
      u.push_back(random.next_vec3());
    }
  }
};

/// One line of a table of costs.
[[nodiscard]] inline std::string cost_row(const std::string& name, double nanoseconds) {
  char line[80];
  std::snprintf(line, sizeof line, "%-36s %7.1f ns\n", name.c_str(), nanoseconds);
  return line;
}

/// What costs_row() prints stands below this.
inline constexpr const char* costs_head = "                        eval   sample      pdf\n";

/// One line: what a BSDF's three functions cost.
[[nodiscard]] std::string costs_row(const char* name, const Bsdf auto& bsdf,
                                    const CostInputs& inputs, int rounds) {
  const std::vector<vec3>&wo = inputs.wo, &wi = inputs.wi, &u = inputs.u;
  const auto eval = [&](std::size_t i) { return dot(bsdf.eval(wo[i], wi[i]), vec3(1.0f)); };
  const auto sample = [&](std::size_t i) { return sampled(bsdf, wo[i], u[i]); };
  const auto pdf = [&](std::size_t i) { return bsdf.pdf(wo[i], wi[i]); };
  char line[80];
  std::snprintf(line, sizeof line, "%-20s %7.1f  %7.1f  %7.1f ns\n", name,
                nanoseconds(eval, rounds), nanoseconds(sample, rounds), nanoseconds(pdf, rounds));
  return line;
}

// [cost-table]
/// Nanoseconds of each step, as text.
/// @param rounds  of each measurement, a tenth of it for paths; 500 take three seconds in all
[[nodiscard]] inline std::string cost_table(int rounds) {
  const CostInputs inputs;
  const std::vector<vec3>&wo = inputs.wo, &u = inputs.u;
  std::string text;
  const auto row = [&](const char* name, double time) { text += cost_row(name, time); };
  const auto time = [&](const auto& f) { return nanoseconds(f, rounds); };
  const CosineLambert matt{Rgb(0.5f)};
  const Mirror mirror{gold};
  const Glass glass{1.0f, 1.5f};
  row("Schlick", time([&](std::size_t i) { return schlick(wo[i].z, 0.04f); }));
  row("dielectric", time([&](std::size_t i) { return fresnel_dielectric(wo[i].z, 1.0f, 1.5f); }));
  row("conductor, one channel",
      time([&](std::size_t i) { return fresnel_conductor(wo[i].z, 1.0f, 0.277f, 2.92f); }));
  row("sample matt", time([&](std::size_t i) { return sampled(matt, wo[i], u[i]); }));
  row("sample mirror", time([&](std::size_t i) { return sampled(mirror, wo[i], u[i]); }));
  row("sample glass", time([&](std::size_t i) { return sampled(glass, wo[i], u[i]); }));
  TexturedScene room = matt_room(64);
  for (Look& look : room.looks)
    look.material.type = MaterialType::dielectric;  // no mirror: the same paths both times
  const int paths = std::max(1, rounds / 10);
  row("path in the matt room, known matt",
      path_nanoseconds(
          room, [](const Surface& s) { return cosine_lambert_at(s); }, paths));
  row("path in the matt room, one of three",
      path_nanoseconds(
          room, [](const Surface& s) { return smooth_bsdf_at(s); }, paths));
  return text;
}
// [cost-table]

}  // namespace lt
