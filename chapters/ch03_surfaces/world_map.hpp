/// @file
/// A map of the world, from a table of outlines, a table of landscapes, and noise.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

#include "ch03_surfaces/noise.hpp"
#include "ch03_surfaces/texture.hpp"
#include "ch03_surfaces/world_outline.hpp"

namespace lt {

// [fill-span]
/// Paints one row of a map of land shares from column `from` to column `to`, fractions included.
inline void fill_span(Image& shares, int row, double from, double to, bool is_land) {
  for (int x = static_cast<int>(std::floor(from)); x < to; ++x) {
    const double covered = std::min(to, x + 1.0) - std::max(from, static_cast<double>(x));
    Rgb& share = shares.at(wrap(x, shares.width()), row);
    share = glm::mix(share, Rgb(is_land ? 1.0f : 0.0f), static_cast<float>(covered));
  }
}
// [fill-span]

// [fill]
/// Paints the inside of an outline: along each parallel, what lies between the first crossing and
/// the second, between the third and the fourth, ...
inline void fill(Image& shares, const Outline& outline) {
  for (int row = 0; row < shares.height(); ++row) {
    const double lat = 90.0 - (row + 0.5) * 180.0 / shares.height();
    std::vector<double> crossings;  // in columns
    LonLat from = outline.points.back();
    for (const LonLat& to : outline.points) {
      if ((from.lat > lat) != (to.lat > lat)) {
        const double lon = std::lerp(from.lon, to.lon, (lat - from.lat) / (to.lat - from.lat));
        crossings.push_back((lon + 180.0) / 360.0 * shares.width());
      }
      from = to;
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      fill_span(shares, row, crossings[i], crossings[i + 1], outline.is_land);
  }
}
// [fill]

/// How much of each texel is land, 0 to 1 (in all three channels); coasts as straight as the
/// table's.
[[nodiscard]] inline Image land_shares(int width) {
  Image shares(width, width / 2);
  for (const Outline& outline : world_outlines())
    fill(shares, outline);
  return shares;
}

// [globe-noise]
/// Noise for a globe: on the map where the map is about true, and near the poles, where the map is
/// stretched from pole to all longitudes, on a disc seen from above the pole.
[[nodiscard]] inline float globe_fbm(vec2 uv, int cells, int octaves, std::uint32_t seed) {
  const float near_pole = glm::smoothstep(0.28f, 0.36f, std::abs(uv.y - 0.5f));  // 50 to 65 degrees
  float sum = 0.0f;
  if (near_pole < 1.0f) sum += (1.0f - near_pole) * fbm(uv, {cells, cells / 2}, octaves, seed);
  if (near_pole > 0.0f) {
    const vec2 direction(std::cos(2.0f * pi * uv.x), std::sin(2.0f * pi * uv.x));
    const float radius = std::sin(pi * uv.y) / (2.0f * pi);
    sum += near_pole * fbm(radius * direction, ivec2(cells), octaves, uv.y < 0.5f ? seed : ~seed);
  }
  return sum;
}
// [globe-noise]

namespace world {

// Reflectances, linear, as seen from above.
inline constexpr Rgb jungle(0.030f, 0.080f, 0.024f), savanna(0.17f, 0.17f, 0.070f),
    steppe(0.23f, 0.20f, 0.105f), meadow(0.095f, 0.130f, 0.048f), taiga(0.040f, 0.070f, 0.036f),
    tundra(0.18f, 0.165f, 0.120f), sand(0.54f, 0.40f, 0.23f), red_sand(0.40f, 0.20f, 0.095f),
    rock(0.24f, 0.19f, 0.14f), ice(0.80f, 0.84f, 0.88f), deep_sea(0.009f, 0.033f, 0.100f),
    warm_sea(0.012f, 0.055f, 0.150f), shelf(0.030f, 0.13f, 0.22f);

/// What grows at a latitude, north or south, where nothing else is said.
struct Belt {
  float lat;
  Rgb color;
};
inline constexpr std::array belts{Belt{0, jungle},   Belt{8, jungle},  Belt{16, savanna},
                                  Belt{26, savanna}, Belt{34, steppe}, Belt{44, meadow},
                                  Belt{53, meadow},  Belt{59, taiga},  Belt{65, taiga},
                                  Belt{71, tundra},  Belt{76, tundra}, Belt{80, ice}};

/// A region with a landscape of its own, an ellipse; later ones lie over earlier ones.
struct Region {
  vec2 middle;     ///< longitude, latitude, degrees
  vec2 half_axes;  ///< degrees
  Rgb color;
};
inline constexpr std::array regions{Region{{36, 0}, {7, 10}, savanna},      // East Africa
                                    Region{{23, 0}, {10, 7}, jungle},       // Congo
                                    Region{{-2, 23}, {20, 8}, sand},        // Sahara
                                    Region{{22, 23}, {18, 8}, sand},        //
                                    Region{{46, 6}, {6, 6}, steppe},        // Horn of Africa
                                    Region{{19, -24}, {7, 8}, red_sand},    // Namib, Kalahari
                                    Region{{47, 24}, {14, 10}, sand},       // Arabia
                                    Region{{60, 32}, {10, 6}, sand},        // Iran
                                    Region{{63, 42}, {12, 6}, steppe},      // Turkestan
                                    Region{{71, 27}, {4, 4}, sand},         // Thar
                                    Region{{87, 34}, {14, 5}, rock},        // Tibet
                                    Region{{84, 39}, {9, 3}, sand},         // Taklamakan
                                    Region{{104, 43}, {12, 4}, sand},       // Gobi
                                    Region{{112, 26}, {10, 6}, meadow},     // South China
                                    Region{{104, 16}, {8, 9}, jungle},      // Indochina
                                    Region{{122, 12}, {7, 8}, jungle},      // Philippines
                                    Region{{131, -25}, {16, 8}, red_sand},  // Australia
                                    Region{{-82, 37}, {10, 8}, meadow},     // Appalachians
                                    Region{{-111, 34}, {9, 8}, sand},       // Sonora, Great Basin
                                    Region{{-113, 46}, {5, 10}, rock},      // Rocky Mountains
                                    Region{{-87, 14}, {8, 6}, jungle},      // Central America
                                    Region{{-62, -5}, {13, 9}, jungle},     // Amazon
                                    Region{{-54, -24}, {8, 9}, meadow},     // Parana
                                    Region{{-68, -44}, {5, 9}, steppe},     // Patagonia
                                    Region{{-69, -22}, {3, 11}, rock},      // Andes
                                    Region{{-41, 73}, {17, 10}, ice},       // Greenland
                                    Region{{-42, 66}, {8, 6}, ice}};

/// @param lon_lat  degrees; moved about by noise, or the borders would be circles and ellipses
[[nodiscard]] inline Rgb land_color(vec2 lon_lat) {
  if (lon_lat.y < -60.0f) return ice;

  // Between the two belts around this latitude.
  const float lat = std::min(std::abs(lon_lat.y), 79.9f);
  const auto upper = std::find_if(belts.begin(), belts.end(), [&](Belt b) { return b.lat > lat; });
  const auto lower = std::prev(upper);
  Rgb color = glm::mix(lower->color, upper->color, (lat - lower->lat) / (upper->lat - lower->lat));

  // The regions over it.
  for (const Region& region : regions) {
    const vec2 away = (lon_lat - region.middle) / region.half_axes;
    color = glm::mix(region.color, color, glm::smoothstep(0.4f, 1.4f, dot(away, away)));
  }
  return color;
}

/// @param lat   degrees; moved about by noise
/// @param land  share of land within a few degrees
[[nodiscard]] inline Rgb sea_color(float lat, float land) {
  const Rgb open = glm::mix(warm_sea, deep_sea, glm::smoothstep(10.0f, 50.0f, std::abs(lat)));
  const Rgb water = glm::mix(open, shelf, glm::smoothstep(0.0f, 0.7f, land));
  return glm::mix(water, ice, glm::smoothstep(77.0f, 81.0f, lat));
}

}  // namespace world

// [world-map]
/// The Earth, equirectangular: longitude -180 at the left edge, 180 at the right; latitude 90 at
/// the top, -90 at the bottom.
/// @param width  texels, even, >= 16; the height is half of it
/// @return linear reflectance, 0 to 1
[[nodiscard]] inline Image world_map(int width) {
  assert(width >= 16 && width % 2 == 0);
  const Image land = land_shares(width);
  const Image land_around = land_shares(width / 16 * 2);  // coarse, and between its texels: soft
  Image map(width, width / 2);
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) {
      const vec2 uv = (vec2(x, y) + 0.5f) / vec2(map.width(), map.height());
      const vec2 lon_lat(360.0f * uv.x - 180.0f, 90.0f - 180.0f * uv.y);
      const float around = bilinear(land_around, uv).x;
      if (around == 0.0f && lon_lat.y < 65.0f) {  // most of the Earth: open sea
        map.at(x, y) = world::sea_color(lon_lat.y, 0.0f);
        continue;
      }

      // Coasts: is there land a little beside this point? Landscapes: farther beside.
      const vec2 fray(globe_fbm(uv, 56, 5, 400), globe_fbm(uv, 56, 5, 420));
      const vec2 drift(globe_fbm(uv, 18, 6, 440), 0.6f * fray.y);
      const float is_land = bilinear(land, uv + vec2(0.009f, 0.018f) * fray).x;

      const Rgb sea = world::sea_color(lon_lat.y + 20.0f * drift.x, around);
      const Rgb ground = world::land_color(lon_lat + 30.0f * drift) * (1.0f + 0.9f * fray.x);
      const Rgb color = glm::mix(sea, ground, glm::smoothstep(0.3f, 0.7f, is_land));
      map.at(x, y) = glm::min(color, 1.0f);
    }
  return map;
}
// [world-map]

}  // namespace lt
