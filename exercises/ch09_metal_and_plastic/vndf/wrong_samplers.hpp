/// @file
/// Samplers that the checker of exercise 09.3 knows to be wrong, and how many normals they give
/// where.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "formulas.hpp"

namespace oracle {

// The parts of a sampler, right ones first.
inline dvec3 stretched(dvec3 v, double a = alpha) {
  return normalize(dvec3(a * v.x, a * v.y, v.z));
}
inline dvec3 at_height(double z, double turn) {
  return {
      std::sqrt(std::max(0.0, 1 - z * z)) * dvec2(std::cos(2 * pi * turn), std::sin(2 * pi * turn)),
      z};
}
// Dupuy and Benyoub 2023: even over the cap above -v.z.
inline dvec3 cap(dvec3 v, dvec2 u) {
  return at_height((1 - u.y) * (1 + v.z) - v.z, u.x);
}
// Heitz 2018: the ball's normal at a place of its picture, and one axis of the picture.
inline dvec3 on_ball(dvec3 v, dvec3 level, double a, double b) {
  return a * level + b * cross(v, level) + std::sqrt(std::max(0.0, 1 - a * a - b * b)) * v;
}
inline dvec3 level_of(dvec3 v) {
  return normalize(dvec3(-v.y, v.x, 0));
}
inline dvec2 disk(double radius, double turn) {
  return radius * dvec2(std::cos(2 * pi * turn), std::sin(2 * pi * turn));
}
inline double squeezed(dvec2 t, double share) {
  return (1 - share) * std::sqrt(1 - t.x * t.x) + share * t.y;
}
inline dvec3 by_disk(dvec3 v, dvec2 t) {
  return stretched(on_ball(v, level_of(v), t.x, squeezed(t, (1 + v.z) / 2)));
}

// Where a mistaken sampler looks: `o` is wo, `v` the view, stretched as it should be.
using Sampler = dvec3 (*)(dvec3 o, dvec3 v, dvec2 u);
inline const std::vector<std::pair<const char*, Sampler>> mistakes{
    {"not-unstretched", [](dvec3, dvec3 v, dvec2 u) { return normalize(cap(v, u) + v); }},
    {"not-stretched", [](dvec3 o, dvec3, dvec2 u) { return stretched(cap(o, u) + o); }},
    {"alpha-ignored", [](dvec3 o, dvec3, dvec2 u) { return normalize(cap(o, u) + o); }},
    {"normals-as-points",
     [](dvec3, dvec3 v, dvec2 u) { return stretched(cap(v, u) + v, 1 / alpha); }},
    {"view-flattened",
     [](dvec3 o, dvec3, dvec2 u) {
       const dvec3 v = stretched(o, 1 / alpha);
       return stretched(cap(v, u) + v);
     }},
    {"view-not-unit",
     [](dvec3 o, dvec3, dvec2 u) {
       const dvec3 v(alpha * o.x, alpha * o.y, o.z);
       return stretched(cap(v, u) + v);
     }},
    {"alpha-squared",
     [](dvec3 o, dvec3, dvec2 u) {
       const dvec3 v = stretched(o, alpha * alpha);
       return stretched(cap(v, u) + v, alpha * alpha);
     }},
    {"azimuth-forgotten",
     [](dvec3, dvec3 v, dvec2 u) {
       const dvec3 turned(std::hypot(v.x, v.y), 0, v.z);
       return stretched(cap(turned, u) + turned);
     }},
    {"wo-ignored", [](dvec3, dvec3, dvec2 u) { return stretched(at_height(std::sqrt(u.y), u.x)); }},
    {"backs-turned",
     [](dvec3 o, dvec3, dvec2 u) {
       const dvec3 h = stretched(at_height(std::sqrt(u.y), u.x));
       return dot(o, h) < 0 ? dvec3(-h.x, -h.y, h.z) : h;
     }},
    {"whole-ball",
     [](dvec3, dvec3 v, dvec2 u) { return stretched(at_height(1 - 2 * u.y, u.x) + v); }},
    {"half-sphere", [](dvec3, dvec3 v, dvec2 u) { return stretched(at_height(1 - u.y, u.x) + v); }},
    {"cap-sign",
     [](dvec3, dvec3 v, dvec2 u) {
       return stretched(at_height((1 - u.y) * (1 - v.z) + v.z, u.x) + v);
     }},
    {"not-half-way", [](dvec3, dvec3 v, dvec2 u) { return stretched(cap(v, u)); }},
    {"half-turn",
     [](dvec3, dvec3 v, dvec2 u) {
       return stretched(cap(v, {u.x / 2, u.y}) + v);
     }},
    {"half-turn",
     [](dvec3, dvec3 v, dvec2 u) { return by_disk(v, disk(std::sqrt(u.y), u.x / 2)); }},
    {"sine-not-rooted",
     [](dvec3, dvec3 v, dvec2 u) {
       const dvec3 w = cap(v, u);
       return stretched(dvec3(dvec2(w) * std::sqrt(1 - w.z * w.z), w.z) + v);
     }},
    {"squeezed-the-wrong-way",
     [](dvec3, dvec3 v, dvec2 u) {
       const dvec2 t = disk(std::sqrt(u.y), u.x);
       return stretched(on_ball(v, level_of(v), t.x, squeezed(t, (1 - v.z) / 2)));
     }},
    {"squeezed-by-wo",
     [](dvec3 o, dvec3 v, dvec2 u) {
       const dvec2 t = disk(std::sqrt(u.y), u.x);
       return stretched(on_ball(v, level_of(v), t.x, squeezed(t, (1 + o.z) / 2)));
     }},
    {"disk-radius-even", [](dvec3, dvec3 v, dvec2 u) { return by_disk(v, disk(u.y, u.x)); }},
    {"axes-not-unit",
     [](dvec3, dvec3 v, dvec2 u) {
       const dvec2 t = disk(std::sqrt(u.y), u.x);
       return stretched(on_ball(v, {-v.y, v.x, 0}, t.x, squeezed(t, (1 + v.z) / 2)));
     }},
};
// 100,000 normals of a mistaken sampler, without chance (Roberts 2018), in their cells.
inline std::vector<double> expected_of(Sampler sampler, double count) {
  std::vector<dvec3> normals(100'000);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const dvec2 u = fract(0.5 + static_cast<double>(i) * dvec2(0.7548776662, 0.5698402910));
    normals[i] = sampler(low, stretched(low), u);
  }
  std::vector<double> expected = counts_of(normals);
  for (double& number : expected)
    number = number * count / 100'000 + 1e-9;
  return expected;
}

}  // namespace oracle
