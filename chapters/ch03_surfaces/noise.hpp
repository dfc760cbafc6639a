/// @file
/// Noise that repeats: random hills, spots and numbers on a unit square whose opposite edges fit
/// together. Whole numbers and plain sums and products only: every compiler makes the same noise.
#pragma once

#include <cassert>
#include <cmath>
#include <cstdint>

#include "ch03_surfaces/texture.hpp"

namespace lt {

// [scramble]
/// Mixes 32 bits until neighbouring numbers have nothing in common; no two give the same result.
/// Constants: C. Wellons, "Prospecting for Hash Functions", 2018 (his "lowbias32").
[[nodiscard]] constexpr std::uint32_t scramble(std::uint32_t bits) {
  bits ^= bits >> 16;
  bits *= 0x7feb352dU;
  bits ^= bits >> 15;
  bits *= 0x846ca68bU;
  bits ^= bits >> 16;
  return bits;
}

/// 32 random bits that belong to the cell in column x and row y; another seed, other bits.
[[nodiscard]] constexpr std::uint32_t cell_bits(int x, int y, std::uint32_t seed) {
  const std::uint32_t row = scramble(static_cast<std::uint32_t>(y) + seed * 0x9e3779b9U);
  return scramble(static_cast<std::uint32_t>(x) + row);
}

/// A random number that belongs to a cell: uniform in [0, 1).
[[nodiscard]] constexpr float cell_random(int x, int y, std::uint32_t seed) {
  return static_cast<float>(cell_bits(x, y, seed) >> 8) * 0x1p-24f;  // 24 bits: all a float holds
}
// [scramble]

// [grid]
/// Where a point lies on a grid of cells on the unit square, which repeats without end.
struct GridPoint {
  ivec2 cell;   ///< column and row, from 0
  vec2 within;  ///< from the cell's top left corner, 0 to 1
};

/// @param cells  along u and v, >= 1
[[nodiscard]] inline GridPoint on_grid(vec2 uv, ivec2 cells) {
  assert(cells.x >= 1 && cells.y >= 1);
  const vec2 p = (uv - glm::floor(uv)) * vec2(cells);
  const ivec2 cell(p);
  return {{wrap_near(cell.x, cells.x), wrap_near(cell.y, cells.y)}, p - vec2(cell)};
}
// [grid]

/// 0 to 1 for t from 0 to 1, with zero slope and curvature at both ends (Perlin 2002).
[[nodiscard]] constexpr float smoother(float t) {
  return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

// [noise]
/// Gradient noise (Perlin 1985): 0 at each crossing of a grid, where it has a random slope.
/// @param uv     any; repeats with period 1
/// @param cells  cells of the grid along u and v, >= 1: more cells, smaller hills
/// @return -1 to 1, mean 0, mostly within +-0.4
[[nodiscard]] inline float noise(vec2 uv, ivec2 cells, std::uint32_t seed) {
  const GridPoint p = on_grid(uv, cells);

  // The plane through 0 at a corner of the cell, with that corner's slopes, both in [-1, 1].
  const auto plane = [&](int right, int down) {
    const std::uint32_t bits =
        cell_bits(wrap_near(p.cell.x + right, cells.x), wrap_near(p.cell.y + down, cells.y), seed);
    const vec2 slope = vec2(bits & 0xffffU, bits >> 16) / 32767.5f - 1.0f;
    return dot(slope, p.within - vec2(right, down));
  };

  // Blend the four corners' planes.
  const float x = smoother(p.within.x);
  const float y = smoother(p.within.y);
  return glm::mix(glm::mix(plane(0, 0), plane(1, 0), x), glm::mix(plane(0, 1), plane(1, 1), x), y);
}
// [noise]

// [fbm]
/// Noise upon noise: each octave has half the height and half the size of the one before
/// (fractional Brownian motion with H = 1; Mandelbrot and Van Ness 1968).
/// @param cells    of the first octave's grid
/// @param octaves  1 to 8
/// @return -1 to 1, mean 0, mostly within +-0.25
[[nodiscard]] inline float fbm(vec2 uv, ivec2 cells, int octaves, std::uint32_t seed) {
  float sum = 0.0f;
  float amplitude = 0.5f;  // 1/2 + 1/4 + ... < 1
  for (int octave = 0; octave < octaves; ++octave) {
    // Shifted against each other, or the grids' crossings, where noise is 0, would all coincide.
    const vec2 shift(cell_random(octave, 0, seed), cell_random(octave, 1, seed));
    sum += amplitude * noise(uv + shift, cells, seed + octave);
    amplitude /= 2.0f;
    cells *= 2;
  }
  return sum;
}
// [fbm]

// [pits]
/// Round hollows strewn over the square, at most one to a cell of a grid, of random size and place.
/// @param share  of the cells that have one, 0 to 1
/// @return depth: 0 outside, rising to at most 1 in the middle of the largest
[[nodiscard]] inline float pits(vec2 uv, ivec2 cells, float share, std::uint32_t seed) {
  const GridPoint p = on_grid(uv, cells);
  const auto luck = [&](int draw) { return cell_random(p.cell.x, p.cell.y, seed + draw); };
  if (luck(0) >= share) return 0.0f;

  const float radius = 0.1f + 0.3f * luck(1) * luck(1);  // in cells: many small ones, few large
  const vec2 center = radius + (1.0f - 2.0f * radius) * vec2(luck(2), luck(3));
  const float distance = glm::distance(p.within, center) / radius;
  return distance < 1.0f ? radius / 0.4f * (1.0f - distance * distance) : 0.0f;
}
// [pits]

}  // namespace lt
